// The scene in a headset, by WebXR: stereo, a controller as the hand, its motor for the force.
import { Group } from "three";
import { placeCamera } from "./camera.js";
import { noteSample } from "./hand.js";
import { resize } from "./scene.js";
import { colour } from "./theme.js";
import { dropXrHand, makeRoom, makeXrHand, stepXrHand } from "./xrhand.js";

const MODES = [["immersive-vr", "Enter VR"], ["immersive-ar", "Enter AR"]];
const BEFORE = [0, -0.3, -0.55]; // where the middle of the scene stands, from where the head was first [m; XR]
const SHOWN = 0.22;              // its radius there [m]
const STICK = 0.2;               // of a thumbstick that nobody touches
const PULSE = 60;                // between pulses of the motor [ms]

/// What of it this browser and what is plugged in can do: [[mode, name of its button]].
export async function supportedModes(api = navigator.xr) {
  if (!api) return [];
  const can = await Promise.all(MODES.map(([mode]) => api.isSessionSupported(mode).catch(() => false)));
  return MODES.filter((_, k) => can[k]);
}

/// world   {stage, player, take(): the page's hand in place of another device, moment(): shows the newest,
///          strength(): of the pulses, 0 to 1, changed(): a session has begun or ended, leave(): gives the device back}
export function makeXr(world) {
  return { world, session: null, mode: null, busy: false, rig: new Group(), room: null, hand: makeXrHand(), grabbing: new Set(), freeing: new Set(),
    last: 0, pulsed: 0, frames: 0 };
}

/// Whether the hand is where a controller says, frame by frame, and nothing else may say that it is still there.
export const holdsXr = (xr) => Boolean(xr?.session) && xr.hand.source !== null;

/// Begins a session of a mode, or ends the one there is. Rejects with the browser's reason.
export async function toggleXr(xr, mode) {
  if (xr.busy) return;
  if (xr.session) { await xr.session.end(); return; }
  xr.busy = true;
  try {
    await enter(xr, mode);
  } finally {
    xr.busy = false;
  }
  xr.world.changed();
}

async function enter(xr, mode) {
  const { stage } = xr.world, { renderer } = stage;
  const session = await navigator.xr.requestSession(mode, { optionalFeatures: ["hand-tracking"] });
  session.addEventListener("visibilitychange", () => { if (session.visibilityState !== "visible") lift(xr); });
  for (const [name, set] of [["select", xr.grabbing], ["squeeze", xr.freeing]]) {
    session.addEventListener(`${name}start`, ({ inputSource }) => set.add(inputSource));
    session.addEventListener(`${name}end`, ({ inputSource }) => set.delete(inputSource));
  }
  Object.assign(xr, { session, mode, last: 0, frames: 0 });
  stand(xr, makeRoom(stage.view.azimuth, SHOWN, stage.radius));
  stage.scene.add(xr.rig);
  xr.rig.add(stage.view.camera);
  renderer.xr.enabled = true;
  renderer.xr.setReferenceSpaceType("local");
  if (mode === "immersive-vr") renderer.setClearColor(colour("stage"), 1);
  const ready = renderer.xr.setSession(session);
  session.addEventListener("end", () => left(xr, session)); // after the renderer's own listener
  try {
    await ready;
  } catch (error) {
    await session.end().catch(() => {});
    left(xr, session);
    throw error;
  }
  if (xr.session === session) renderer.xr.setAnimationLoop((time, frame) => step(xr, time, frame));
}

/// The rig takes the room to what the picture is drawn in, where the scene has radius 1 about its target.
function stand(xr, room) {
  const { rig, world: { stage } } = xr;
  xr.room = room;
  rig.quaternion.fromArray(room.turn);
  rig.scale.setScalar(1 / room.shown);
  rig.position.fromArray(BEFORE).applyQuaternion(rig.quaternion).multiplyScalar(-1 / room.shown).add(stage.view.target);
  rig.updateMatrixWorld();
}

function left(xr, session) {
  if (xr.session !== session) return;
  const { stage, leave, changed } = xr.world, { renderer } = stage;
  xr.session = xr.mode = null;
  lift(xr);
  leave();
  for (const set of [xr.grabbing, xr.freeing, xr.hand.down]) set.clear();
  renderer.xr.setAnimationLoop(null);
  renderer.setAnimationLoop(null);
  renderer.xr.enabled = false;
  renderer.setClearColor(0, 0);
  xr.rig.remove(stage.view.camera);
  stage.scene.remove(xr.rig);
  stage.view.camera.scale.setScalar(1);
  resize(stage);
  placeCamera(stage.view);
  changed();
}

/// Forces go off, as nobody knows where the hand is.
function lift(xr) {
  if (xr.hand.source === null) return;
  dropXrHand(xr.hand);
  xr.world.player.letGo();
}

/// Position and direction of a grip, null where the headset only guesses them.
function gripOf(frame, source, space) {
  const pose = frame.getPose(source.gripSpace, space);
  if (!pose || pose.emulatedPosition) return null;
  const { position: p, orientation: q } = pose.transform;
  return { position: [p.x, p.y, p.z], quaternion: [q.x, q.y, q.z, q.w] };
}

function step(xr, time, frame) {
  const { world, session } = xr;
  if (!session) return;
  if (xr.room.radius !== world.stage.radius) stand(xr, makeRoom(xr.room.azimuth, xr.room.shown, world.stage.radius)); // another scene
  const seconds = Math.min(0.1, (time - xr.last) / 1000);
  xr.last = time;
  xr.frames += 1;
  const space = world.stage.renderer.xr.getReferenceSpace();
  const inputs = [...session.inputSources].filter(({ gripSpace }) => gripSpace).map((source) => ({ source,
    grabs: xr.grabbing.has(source), free: xr.freeing.has(source), pose: gripOf(frame, source, space) }));
  moveBy(xr, inputs);
  if (xr.hand.source === null) for (const { source } of inputs) turnRoom(xr, source, seconds);
  else pulse(xr, time);
  world.moment();
  const { stage } = world;
  stage.renderer.shadowMap.needsUpdate = stage.moved;
  stage.moved = stage.dirty = false;
  stage.renderer.render(stage.scene, stage.view.camera);
}

function moveBy(xr, inputs) {
  const { player, take } = xr.world;
  const did = stepXrHand(xr.hand, inputs, xr.room, player.hand, player.workspace());
  if (did === "letGo") player.letGo();
  else if (did === "press" && !player.mayMove()) {
    dropXrHand(xr.hand); // the next press
    take();
  } else if (did === "press") player.press();
  if (xr.hand.source === null) return;
  noteSample(player.hand, performance.now() / 1000);
  player.moved(true);
  player.give();
}

/// The thumbstick of a hand that holds nothing: up and down the size of the scene in the room, left and right its turn.
function turnRoom(xr, { gamepad }, seconds) {
  const [, , aside = 0, ahead = 0] = gamepad?.axes ?? [];
  if (Math.hypot(aside, ahead) < STICK) return;
  const { azimuth, shown } = xr.room;
  stand(xr, makeRoom(azimuth + 1.5 * seconds * aside, shown * Math.exp(-1.2 * seconds * ahead), xr.world.stage.radius));
}

function pulse(xr, time) {
  const { gamepad } = xr.hand.source, strength = xr.world.strength();
  if (!gamepad || strength < 0.02 || time - xr.pulsed < PULSE) return;
  xr.pulsed = time;
  const [motor] = gamepad.hapticActuators ?? [];
  if (motor?.pulse) motor.pulse(strength, PULSE + 20)?.catch?.(() => {});
  else gamepad.vibrationActuator?.playEffect?.("dual-rumble", { duration: PULSE + 20, strongMagnitude: strength, weakMagnitude: 0.5 * strength }).catch(() => {});
}
