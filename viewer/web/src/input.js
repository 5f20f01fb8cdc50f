// Mouse, fingers and gamepad: what moves the hand, and what moves the view.
import { Raycaster, Vector2 } from "three";
import { axes, goHome, orbit, pan, zoom } from "./camera.js";
import { metresPerPixel } from "./scene.js";
import { pickBody } from "./world.js";
import { moveHand, noteSample, SHORTEST, turnHand } from "./hand.js";

const TURN_PER_PIXEL = 0.008; // [rad]

/// player   {stage, hand, workspace(), grasp(): world point, mayMove(): the hand is this page's to move,
///           claims(event): something else in the picture takes this press, press(pick: a body of a world, see pickBody): take hold, moved(turned), give(): what was noted, at the end of an event, letGo()}
export function startInput(player) {
  const { canvas } = player.stage;
  const input = { player, pointers: new Map(), mode: null, keys: new Set(), hasPad: false, given: -Infinity, touch: matchMedia("(pointer: coarse)").matches };
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("pointerdown", (event) => down(input, event));
  canvas.addEventListener("pointermove", (event) => move(input, event));
  canvas.addEventListener("pointerrawupdate", (event) => moveAtOnce(input, event));
  for (const kind of ["pointerup", "pointercancel"]) canvas.addEventListener(kind, (event) => up(input, event));
  canvas.addEventListener("wheel", (event) => wheel(input, event), { passive: false });
  addEventListener("keydown", (event) => pressKey(input, event));
  addEventListener("keyup", ({ key }) => input.keys.delete(key));
  addEventListener("blur", () => input.keys.clear());
  addEventListener("gamepadconnected", () => { input.hasPad = true; }); // asking for gamepads has its price
  canvas.addEventListener("dblclick", (event) => { if (event.button === 2) goHome(player.stage.view); });
  return input;
}

function down(input, event) {
  const { canvas } = input.player.stage;
  canvas.focus({ preventScroll: true });
  if (input.player.claims(event)) return; // for the handles of an object
  canvas.setPointerCapture(event.pointerId);
  input.pointers.set(event.pointerId, { x: event.clientX, y: event.clientY, stamp: event.timeStamp });
  input.touch = event.pointerType === "touch";
  const { stage } = input.player, pick = stage.world && event.button === 0 ? pickBody(stage, event) : null;
  const isOn = stage.world ? pick !== null : !input.touch || touchesObject(input, event);
  if (input.touch) {
    if (input.pointers.size === 1) input.mode = isOn && input.player.mayMove() ? "hand" : "view";
  } else if (event.button === 0) {
    input.mode = isOn && input.player.mayMove() ? "hand" : "view";
  } else {
    input.mode = event.button === 1 || event.shiftKey ? "pan" : "view";
  }
  if (input.mode === "hand") input.player.press(pick);
  canvas.classList.toggle("grabbing", input.mode === "hand");
}

function touchesObject({ player: { stage } }, event) {
  if (!stage.object) return false;
  const box = stage.canvas.getBoundingClientRect();
  const at = new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
  const ray = new Raycaster();
  ray.setFromCamera(at, stage.view.camera);
  return ray.intersectObject(stage.object.finest.solid, false).length > 0;
}

/// The hand does not wait for the next frame of the browser, which brings `pointermove`: half a frame in the mean.
function moveAtOnce(input, event) {
  if (input.mode !== "hand" || input.pointers.size !== 1) return;
  if (event.timeStamp - input.given >= 1000 * SHORTEST) move(input, event); // else `pointermove` brings it
}

function move(input, event) {
  const last = input.pointers.get(event.pointerId);
  if (!last) return;
  if (input.pointers.size === 2) {
    moveTwo(input, event, last);
  } else {
    const events = event.getCoalescedEvents?.() ?? [];
    for (const one of events.length > 0 ? events : [event]) {
      if (one.timeStamp <= last.stamp) continue; // came at once
      last.stamp = one.timeStamp;
      step(input, one, one.clientX - last.x, one.clientY - last.y);
      last.x = one.clientX;
      last.y = one.clientY;
    }
  }
  last.x = event.clientX;
  last.y = event.clientY;
  if (input.mode !== "hand") return;
  input.given = event.timeStamp;
  input.player.give();
}

function step(input, event, dx, dy) {
  const { stage } = input.player;
  if (dx === 0 && dy === 0) return;
  if (input.mode === "view") return orbit(stage.view, dx, dy);
  if (input.mode === "pan") return pan(stage.view, dx, dy, stage.canvas.clientHeight);
  if (input.mode !== "hand") return undefined;
  if (event.ctrlKey || event.altKey || event.metaKey) return turnBy(input, dx, dy, 0, event.timeStamp);
  if (event.shiftKey) return shift(input, 0, 0, -dy, event.timeStamp);
  return shift(input, dx, dy, 0, event.timeStamp);
}

/// dx, dy in pixels of the picture, deep in pixels away from the eye.
function shift(input, dx, dy, deep, stamp) {
  const { stage, hand } = input.player;
  const size = metresPerPixel(stage, input.player.grasp());
  const { right, up, forward } = axes(stage.view);
  const way = [0, 1, 2].map((k) => size * (dx * right.getComponent(k) - dy * up.getComponent(k) + deep * forward.getComponent(k)));
  moveHand(hand, way, input.player.workspace());
  noteSample(hand, stamp / 1000);
  input.player.moved(false);
}

/// As if a ball were rolled under the pointer; roll turns it about the line of sight [rad].
function turnBy(input, dx, dy, roll, stamp) {
  const { stage, hand } = input.player;
  const { right, up, forward } = axes(stage.view);
  const workspace = input.player.workspace();
  turnHand(hand, up.toArray(), TURN_PER_PIXEL * dx, workspace);
  turnHand(hand, right.toArray(), TURN_PER_PIXEL * dy, workspace);
  if (roll !== 0) turnHand(hand, forward.toArray(), roll, workspace);
  noteSample(hand, stamp / 1000);
  input.player.moved(true);
}

/// Two fingers: on the object they turn it and, spread, bring it nearer; beside it they move and zoom the view.
function moveTwo(input, event, last) {
  const [other] = [...input.pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
  const before = { x: last.x - other.x, y: last.y - other.y };
  const after = { x: event.clientX - other.x, y: event.clientY - other.y };
  const spread = (Math.hypot(after.x, after.y) || 1) / (Math.hypot(before.x, before.y) || 1);
  const roll = Math.atan2(before.x * after.y - before.y * after.x, before.x * after.x + before.y * after.y);
  const dx = 0.5 * (event.clientX - last.x), dy = 0.5 * (event.clientY - last.y);
  const { stage } = input.player;
  if (input.mode === "hand") {
    turnBy(input, dx, dy, roll, event.timeStamp);
    shift(input, 0, 0, -200 * Math.log(spread), event.timeStamp);
  } else {
    pan(stage.view, dx, dy, stage.canvas.clientHeight);
    zoom(stage.view, 1 / spread);
  }
}

function up(input, event) {
  input.pointers.delete(event.pointerId);
  if (input.pointers.size > 0) return;
  if (input.mode === "hand" && input.player.stage.world) input.player.letGo(); // it falls, or flies
  input.mode = null;
  input.player.stage.canvas.classList.remove("grabbing");
}

function wheel(input, event) {
  event.preventDefault();
  const pixels = event.deltaY * (event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1);
  if (input.mode === "hand") {
    shift(input, 0, 0, -0.4 * pixels, event.timeStamp);
    input.player.give();
  } else zoom(input.player.stage.view, Math.exp(0.0012 * pixels));
}

const KEYS = { ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowUp: [0, -1, 0], ArrowDown: [0, 1, 0], PageUp: [0, 0, 1], PageDown: [0, 0, -1] };
const KEY_SPEED = 160; // [px/s]

/// Keys that move are those of the picture, not of a list or a slider that has the keyboard.
function pressKey(input, event) {
  const isPicture = event.target === input.player.stage.canvas || event.target === document.body;
  if (!KEYS[event.key] || !isPicture) return;
  event.preventDefault();
  Object.assign(input, { turns: event.ctrlKey || event.altKey || event.metaKey, views: event.shiftKey });
  input.keys.add(event.key);
}

/// Once a frame: the keys that are down move the hand that holds, or turn it, or else the view.
/// seconds   since the last call
export function readKeys(input, seconds) {
  if (input.keys.size === 0) return;
  const { hand, stage } = input.player;
  const pixels = KEY_SPEED * Math.min(0.1, seconds);
  const [dx, dy, deep] = [0, 1, 2].map((k) => pixels * [...input.keys].reduce((sum, key) => sum + KEYS[key][k], 0));
  if (!hand.clutch || input.views) {
    orbit(stage.view, dx, dy);
    if (deep !== 0) zoom(stage.view, Math.exp(-0.004 * deep));
  } else if (input.turns) turnBy(input, dx, dy, 0.01 * deep, performance.now());
  else shift(input, dx, dy, deep, performance.now());
  input.player.give();
}

const DEAD = 0.12; // of a stick

/// Reads a gamepad once a frame: left stick in the picture's plane, triggers depth, right stick turns, first button takes
/// hold, second lets go. Rumble tells the force.
/// seconds   since the last call; newtons, full   the felt force and the one that rumbles fully
export function readGamepad(input, seconds, newtons, full) {
  if (!input.hasPad) return false;
  const pad = [...(navigator.getGamepads?.() ?? [])].find((one) => one?.connected);
  if (!pad) return false;
  const { player } = input;
  const axis = (k) => (Math.abs(pad.axes[k] ?? 0) > DEAD ? pad.axes[k] : 0);
  if (pad.buttons[0]?.pressed && player.mayMove()) player.press();
  if (pad.buttons[1]?.pressed) player.letGo();
  if (player.hand.clutch) {
    const speed = 220 * Math.min(0.1, seconds); // pixels in this time at full stick
    const deep = (pad.buttons[7]?.value ?? 0) - (pad.buttons[6]?.value ?? 0);
    if (axis(0) || axis(1) || deep) shift(input, speed * axis(0), speed * axis(1), speed * deep, performance.now());
    if (axis(2) || axis(3)) turnBy(input, speed * axis(2), speed * axis(3), 0, performance.now());
  }
  rumble(input, pad, Math.min(1, newtons / full));
  return true;
}

function rumble(input, pad, strength) {
  const now = performance.now();
  if (!pad.vibrationActuator?.playEffect || strength < 0.02 || now - (input.rumbled ?? -1e9) < 60) return;
  input.rumbled = now;
  pad.vibrationActuator.playEffect("dual-rumble", { duration: 80, strongMagnitude: strength, weakMagnitude: 0.5 * strength })
    .catch(() => {}); // a pad without motors
}
