// The hand the page stands for: what the mouse, fingers, a gamepad or a controller in a headset add up to, in the device's frame.
import { CLUTCH, MAX_SAMPLES } from "./protocol.js";

export const SHORTEST = 0.004; // between samples, and messages of them: at most 250 a second [s]
const FARTHEST = 9.9;   // positions beyond 10 m are refused [m]

export function makeHand() {
  return { position: [0, 0, 0], quaternion: [0, 0, 0, 1], clutch: false, pending: [], latest: -Infinity };
}

/// Product of quaternions, x y z w.
export function multiply(a, b) {
  return [
    a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
    a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
    a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
    a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2],
  ];
}
export const conjugate = (q) => [-q[0], -q[1], -q[2], q[3]];

export function rotate(q, v) {
  const [x, y, z] = multiply(multiply(q, [...v, 0]), conjugate(q));
  return [x, y, z];
}

export function aboutAxis(axis, angle) {
  const s = Math.sin(0.5 * angle);
  return [s * axis[0], s * axis[1], s * axis[2], Math.cos(0.5 * angle)];
}

/// way        of the hand in the world [m]
/// workspace  of the `scene` message: device d = R^T way / motion_scale
export function moveHand(hand, way, workspace) {
  const step = rotate(conjugate(workspace.quat_xyzw), way);
  hand.position = hand.position.map((value, k) =>
    Math.max(-FARTHEST, Math.min(FARTHEST, value + step[k] / workspace.motion_scale)));
}

/// Turns the hand about a unit axis of the world [rad].
export const turnHand = (hand, axis, angle, workspace) => turnHandBy(hand, aboutAxis(axis, angle), workspace);

/// Turns the hand by a rotation of the world.
export function turnHandBy(hand, turn, workspace) {
  const q = workspace.quat_xyzw;
  const own = multiply(multiply(multiply(conjugate(q), turn), q), hand.quaternion);
  const norm = Math.hypot(...own);
  hand.quaternion = own.map((value) => value / norm);
}

/// Adds a sample to those that wait; sooner than 4 ms after the last it replaces that one, so that the newest position is
/// never lost, unless the buttons differ. More than a message holds push the oldest out.
/// sent   time of the last one that no longer waits [s]
export function addSample(pending, sample, sent = -Infinity) {
  const last = pending[pending.length - 1];
  const since = pending[pending.length - 2]?.time ?? sent;
  if (last && last.buttons === sample.buttons && last.time - since < SHORTEST) pending[pending.length - 1] = sample;
  else pending.push(sample);
  if (pending.length > MAX_SAMPLES) pending.splice(0, pending.length - MAX_SAMPLES);
}

export const poseOf = (hand) => ({ position: [...hand.position], quaternion: [...hand.quaternion] });

/// Notes where the hand is, or was, at a time of the browser's clock [s].
export function noteSample(hand, time, pose = poseOf(hand)) {
  const sample = { time: Math.max(time, hand.latest), ...pose, buttons: hand.clutch ? CLUTCH : 0 };
  addSample(hand.pending, sample, hand.sent);
  hand.latest = sample.time;
}

/// What is to be sent, oldest first; empty when nothing was noted.
export function takeSamples(hand) {
  const samples = hand.pending;
  hand.pending = [];
  if (samples.length > 0) hand.sent = samples[samples.length - 1].time;
  return samples;
}
