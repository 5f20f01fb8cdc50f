// The live page: what the program says goes to the picture, the plots and the words; what the hand does goes back.
import { follow, goHome, lookFrom, zoom } from "./camera.js";
import { addHeadset, makeBar, showHeadset, showHint, showSound, showState, showViews } from "./bar.js";
import { guideLine, makeGuide } from "./guide.js";
import { STATE } from "./protocol.js";
import { makeHand, takeSamples } from "./hand.js";
import { bodyToChange, confirmHand, leaveHold, makeHolding, setHold } from "./holding.js";
import { readGamepad, readKeys, startInput } from "./input.js";
import { ask, makeLink, sendAll, waitingBytes } from "./link.js";
import { addEvent, fillHelp, makeParameters, showParameters } from "./panels.js";
import { addMark, addRates, addRows, clearPlots, drawPlots, makePlots, plotPicture, plotTable, rebuildPlots, setFloors } from "./plots.js";
import { makeReadouts, showLegend, showReadouts, showRowLegend } from "./readouts.js";
import { addModels, makeBuilder, movedTo, openBuilder, takeBuilderScene, takeSaved } from "./builder.js";
import { makeGizmo, showGizmo } from "./gizmo.js";
import { fillLevelBrowser, browsedWords, makeLevelBrowser } from "./levels.js";
import { makeOpener, openMenu, takeMenu, takeModel } from "./open.js";
import { makeReplayBar, showReplayBar, takeStrip } from "./replay.js";
import { makeRulers, PRESETS, showRulers } from "./rulers.js";
import { bodies, browseLevel, draw, isReady, makeScene, repaint, resize, setEditing, setObjects, setOptions, showSnapshot, takeLevel, takeRelief } from "./scene.js";
import { makeSound, playRows, toggleSound } from "./sound.js";
import { startTheme } from "./theme.js";
import { startTabs } from "./tabs.js";
import { eventWords } from "./words.js";
import { veil } from "./veil.js";
import { makeXr, supportedModes, toggleXr } from "./xr.js";

const at = (id) => document.getElementById(id);
const CONFIRM = 50; // the worker is told so often that the hand is still where it was: the force fades with the age of that [ms]

const session = { connected: false, hello: null, scene: null, meshes: new Map(), state: null, parameters: [], snapshot: null, shown: null, bodies: null,
  refusal: null, counts: { snapshot: 0, bodies: 0, channels: 0, mesh: 0, event: 0 }, holding: false,
  turned: false, trouble: null, progress: null, fresh: false, asking: false, sent: 0,
  faultName: () => session.hello?.faults?.[session.snapshot?.fault ?? 0] ?? "fault" };
const hand = makeHand();
const guide = makeGuide();
let stage = null, link = null, xr = null, gizmo = null;

const plots = makePlots(at("plots"), [
  ["PNG", "Save the plots as a picture", () => plotPicture(plots, caption()).toBlob((blob) => save(fileName("png"), blob))],
  ["CSV", "Save the plots as a table", () => save(fileName("csv"), new Blob([plotTable(plots)], { type: "text/csv" }))],
], (time) => session.state?.replay && act.seek(time));
const readouts = makeReadouts(at("readouts"));
const sound = makeSound();
const levels = makeLevelBrowser(at("levels"), (body, level) => stage && bodies(stage)[body] && browseLevel(stage, bodies(stage)[body], level));
const opener = makeOpener(at("opener"), { ask: (message) => ask(link, message), send: (bytes) => sendAll(link, bytes),
  room: () => waitingBytes(link), limit: () => session.hello?.max_message ?? 4096,
  add: (models) => { chooseTab("build"); addModels(builder, models); } });
const builder = makeBuilder(at("build"), { ask: (message) => ask(link, message), choose: () => { act.open(); at("mesh-file").click(); },
  handles: (index, mode, isOpen) => {
    if (!stage) return;
    setEditing(stage, isOpen);
    if (isOpen && !gizmo) gizmo = makeGizmo(stage, (pose) => movedTo(builder, pose));
    if (gizmo) showGizmo(gizmo, index, mode);
  } });
const parameters = makeParameters(at("parameters"), (name, value) => ask(link, { type: "set", name, value }));

/// Asks, and says in the picture why not when the answer is no.
async function request(message) {
  const ack = await ask(link, message);
  if (!ack.ok) session.refusal = { text: ack.reason ?? "The program refused.", until: performance.now() / 1000 + 6 };
  return ack;
}

const act = {
  open: () => (at("opener").open ? at("opener").close() : openMenu(opener, session.scene?.name ?? "")),
  seek: (time) => request({ type: "seek", value: time }),
  pause: () => request({ type: "pause", value: session.state?.run !== "paused" }),
  step: () => request({ type: "step", value: 1 }),
  reset: () => request({ type: "reset" }),
  record: () => request({ type: "record", value: !session.state?.recording }),
  device: (uri) => request({ type: "use_device", value: uri }).then((ack) => hold(ack.ok && uri.startsWith("web:"))),
  help: () => (at("help").open ? at("help").close() : showHelp()),
  theme: () => toggleTheme(),
  view: (option) => {
    if (!stage) return;
    setOptions(stage, { [option]: !stage.options[option] });
    showViews(bar, stage.options);
  },
  fit: () => stage && goHome(stage.view),
  speed: (value) => request({ type: "speed", value }),
  sound: () => showSound(bar, toggleSound(sound)),
  add: () => changeBodies("add"),
  remove: () => changeBodies("remove"),
  look: (way) => stage && lookFrom(stage.view, way),
  zoom: (factor) => stage && zoom(stage.view, factor),
};
function changeBodies(type) {
  const value = bodyToChange(type, session.scene, holding.last);
  if (value !== null) request({ type, value });
  else session.refusal = { text: "Take hold of a body first: the one held last is the one that goes.", until: performance.now() / 1000 + 6 };
}
function showHelp() {
  at("help").showModal();
  at("help").scrollTop = 0; // the button that has the keyboard stands at its end
}
const bar = makeBar(act);
const rulers = makeRulers(at("rulers"), at("names"), act.look);
const replayBar = makeReplayBar(at("replay"), act);
const toggleTheme = startTheme(() => { if (stage) repaint(stage); rebuildPlots(plots); });

// ---- from the program

const on = {
  hello: (message) => { session.hello = message; },
  scene: (message) => {
    const goesOn = message.refined && session.snapshot !== null; // its levels have come, and nothing else
    session.scene = message;
    session.meshes.clear();
    fillLevelBrowser(levels, message);
    if (goesOn) {
      session.bodies = null; // those of a world may have other numbers now
      return;
    }
    session.scene.refined = false;
    session.snapshot = session.shown = session.bodies = null;
    session.fresh = false;
    document.body.classList.toggle("world", Boolean(message.world));
    if (message.world && ["parameters", "levels", "build"].some((id) => !at(id).hidden)) chooseTab("plots");
    veil("Loading the objects …");
  },
  mesh: (message) => {
    session.counts.mesh += 1;
    session.meshes.set(message.number, message);
    const wanted = [session.scene.object, ...session.scene.statics].map((one) => one.mesh);
    if (!wanted.every((number) => session.meshes.has(number))) return;
    const isRefined = session.scene.refined; // the same scene with its levels
    if (gizmo && !isRefined) showGizmo(gizmo, null); // of the objects that go
    if (stage) setObjects(stage, session.scene, session.meshes, isRefined);
    takeBuilderScene(builder, session.scene);
    if (!isRefined) veil(session.trouble);
  },
  level: (message) => { if (stage) takeLevel(stage, message); },
  relief: (message) => { if (stage) takeRelief(stage, message); },
  strip: (message) => takeStrip(replayBar, message),
  menu: (message) => takeMenu(opener, message),
  model: (message) => takeModel(opener, message),
  saved: (message) => takeSaved(builder, message),
  progress: ({ what, share }) => {
    session.progress = what;
    if (what) { // what runs goes on behind it
      at("opener").close();
      veil(`${what[0].toUpperCase()}${what.slice(1)} …`, share, () => request({ type: "cancel" }));
    }
    else veil(session.trouble);
  },
  parameters: (message) => { session.parameters = message.list; showParameters(parameters, message.list); },
  state: (message) => {
    if (session.state && session.state.session !== message.session) begunAgain();
    session.state = message;
    hold(message.holder === "you");
  },
  event: (message) => {
    session.counts.event += 1;
    addEvent(at("events"), message);
    addMark(plots, message.time, message.kind);
    if (["recording_ended", "held_back", "squeezed"].includes(message.kind)) session.refusal = { text: `${eventWords(message)}.`, until: performance.now() / 1000 + 10 };
  },
  bodies: (message) => { // with each snapshot of a world
    session.counts.bodies += 1;
    session.bodies = message;
    session.fresh = session.snapshot !== null;
  },
  camera: (message) => { if (stage) follow(stage.view, message); },
  channels: (message) => {
    session.counts.channels += 1;
    const names = ["t", ...session.hello.channels.map((one) => one.name).filter((name) => name !== "t")];
    addRows(plots, message, names);
    playRows(sound, message, Object.fromEntries(names.map((name, k) => [name, k])), session.state?.limits?.force ?? fullForce());
  },
  snapshot: (message) => {
    session.counts.snapshot += 1;
    const rose = message.bits & ~(session.snapshot?.bits ?? 0);
    session.snapshot = message;
    if (rose & STATE.fault) hand.clutch = false; // to go on takes a new press
    session.fresh = true; // shown with the next picture; of several only the newest
    if (message.metresPerNewton > 0) setFloors(plots, session.scene.object.radius, session.scene.tolerance, message.metresPerNewton);
    addRates(plots, message.time, message.hapticRate, message.contactRate);
  },
};

function begunAgain() {
  hand.clutch = false;
  if (stage) follow(stage.view, null);
  clearPlots(plots);
  at("events").replaceChildren();
}

function lost(sentence) {
  session.connected = false;
  hold(false);
  hand.clutch = false;
  takeSamples(hand);
  document.body.classList.add("lost");
  session.progress = null;
  veil(`${sentence} Nothing is felt or shown any more. ${link?.stopped ? "" : "Trying again …"}`);
}

function opened() {
  session.connected = true;
  document.body.classList.remove("lost");
  veil(null);
}

// ---- from the hand

const holding = makeHolding({ session, hand, request, get stage() { return stage; }, get link() { return link; }, get xr() { return xr; }, get gizmo() { return gizmo; } });
const { player } = holding, hold = (isOurs) => setHold(holding, isOurs), leave = () => leaveHold(holding);

document.addEventListener("visibilitychange", () => { if (document.hidden) leave(); });
addEventListener("pagehide", leave);
addEventListener("keydown", (event) => {
  if (event.target.closest?.("input, select, textarea") || event.ctrlKey || event.metaKey || event.altKey) return;
  const toggle = () => (hand.clutch ? player.letGo() : player.mayMove() && player.press());
  const keys = { " ": toggle, p: act.pause, ".": act.step, r: act.reset, f: act.fit, o: act.open, "?": act.help, h: act.help,
    l: () => act.view("wireframe"), g: () => act.view("ghost"), c: () => act.view("contacts"), a: () => act.view("forces"), n: () => act.view("names"), s: act.sound,
    "+": () => act.zoom(0.87), "-": () => act.zoom(1.15), ...Object.fromEntries(PRESETS.map(([key, , way]) => [key, () => act.look(way)])) };
  const does = keys[event.key.length === 1 ? event.key.toLowerCase() : ""];
  if (!does || (event.key === " " && event.target.closest?.("button"))) return;
  event.preventDefault();
  does();
});

// ---- the picture

function startStage() {
  try {
    stage = makeScene(at("scene"), new URLSearchParams(location.search).get("picture")); // "full" or "plain", whatever the graphics
  } catch (error) {
    session.trouble = "This browser shows no WebGL 2, so there is no picture; numbers and plots work. " +
      "Hardware acceleration may be off in its settings.";
    veil(session.trouble);
    console.warn(String(error.message ?? error));
    return null;
  }
  document.body.classList.toggle("plain", stage.plain);
  if (stage.plain) stage.done = (rest) => setTimeout(() => document.hidden || show(performance.now()), rest); // and not at the next look
  stage.wants = (mesh, level) => ask(link, { type: "level", mesh, value: level });
  repaint(stage);
  showViews(bar, stage.options);
  new ResizeObserver(() => resize(stage)).observe(at("stage"));
  resize(stage);
  startHeadset();
  return startInput(player);
}

async function startHeadset() {
  xr = makeXr({ stage, player, leave, moment: takeMoment, changed: () => showHeadset(bar, xr.mode),
    take: () => { if (session.state?.devices.includes("web:") && !session.state.device.startsWith("web:")) act.device("web:"); },
    strength: () => Math.min(1, newtonsFelt() / fullForce()) });
  addHeadset(bar, await supportedModes(), (mode) => toggleXr(xr, mode).catch(({ message }) => {
    session.refusal = { text: `The headset: ${message}`, until: performance.now() / 1000 + 6 };
  }));
}

function save(name, blob) {
  const anchor = Object.assign(document.createElement("a"), { href: URL.createObjectURL(blob), download: name });
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(anchor.href), 10000);
}
const fileName = (ending) => `thigma-${(session.snapshot?.time ?? 0).toFixed(1)}s.${ending}`;

const input = startStage();
fillHelp(at("help"));
const caption = () => `${session.scene?.title ?? ""}, to ${(session.snapshot?.time ?? 0).toFixed(1)} s`;
const chooseTab = startTabs(at("tabs"), [["plots", "Plots"], ["parameters", "Parameters"], ["levels", "Levels"], ["events", "Events"], ["build", "Scene"]],
  (id) => openBuilder(builder, id === "build"));
rebuildPlots(plots);
veil("Connecting …");
const token = /^#token=([0-9a-f]+)$/.exec(location.hash)?.[1];
link = makeLink(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/live${token ? `?token=${token}` : ""}`, {
  message: (message) => on[message.type ?? message.kind]?.(message), opened, lost,
});
setInterval(confirmHand, CONFIRM, holding);

// Where the processor draws: from one picture to the next behind the progress of what comes, which it loads as well; and from
// one look at keys, gamepad and the last picture to the next, as a frame of the browser has its price even if nothing is drawn.
// From one look at the words to the next where no picture is begun [ms].
const BEHIND = 250, LOOK = 8, WORDS = 100;
let last = performance.now(), drawn = 0, wordsAt = 0, wordsSince = 0, behindAt = 0;

function takeMoment() {
  if (!session.fresh) return;
  session.shown = session.snapshot;
  if (stage) showSnapshot(stage, session.shown, session.bodies);
  session.fresh = false;
}

/// Picture, tiles, sentences and plots show one moment: that of the newest snapshot when a picture is begun.
function showMoment() {
  if (xr?.session) return false; // its frames make the pictures
  if (stage && !isReady(stage)) return false;
  takeMoment();
  if (!stage || !draw(stage)) return false;
  drawn += 1;
  showRulers(rulers, stage, session.shown);
  return true;
}

const waits = () => Boolean(stage?.plain && session.progress);

function frame(now) {
  if (stage?.plain && !document.hidden) setTimeout(() => frame(performance.now()), LOOK);
  else requestAnimationFrame(frame);
  if (input) readGamepad(input, (now - last) / 1000, newtonsFelt(), fullForce());
  if (input) readKeys(input, (now - last) / 1000);
  last = now;
  confirmHand(holding);
  show(now);
}

/// What there is to see, in the page and its picture.
function show(now) {
  if (waits() && now < behindAt) return;
  behindAt = now + BEHIND;
  const isNew = showMoment();
  drawPlots(plots, session.shown?.time ?? 0, stage?.plain);
  const begin = performance.now();
  if (begin < wordsSince + WORDS && !(isNew && begin >= wordsAt)) return;
  showWords(now / 1000, newtonsFelt());
  wordsSince = begin;
  wordsAt = 10 * performance.now() - 9 * begin; // a tenth of the time at most
}

const newtonsFelt = () => (session.snapshot ? Math.hypot(...session.snapshot.force) : 0);

/// The force whose arrow is as long as the object: where rumble is strongest.
function fullForce() {
  const perNewton = session.snapshot?.metresPerNewton;
  return perNewton > 0 && session.scene ? session.scene.object.radius / perNewton : 3;
}

function showWords(now, newtons) {
  showState(bar, session);
  showReadouts(readouts, session, plots.pointed);
  showRowLegend(at("row-legend"), session.shown, Boolean(stage?.world));
  showLegend(at("legend"), session.shown, session.scene, browsedWords(levels));
  showReplayBar(replayBar, session.state, session.shown);
  showHint(at("hint"), guideLine(guide, session, { now, newtons, holding: session.holding && hand.clutch, turned: session.turned, touch: input?.touch ?? matchMedia("(pointer: coarse)").matches }, act));
}
requestAnimationFrame(frame);

/// For tests and the curious: everything the page knows.
window.thigma = { session, hand, input, plots, sound, player, act, ask: (message) => ask(link, message), get stage() { return stage; }, get link() { return link; }, get xr() { return xr; }, builder, opener, get gizmo() { return gizmo; },
  get drawn() { return drawn; } };
