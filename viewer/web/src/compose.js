// A scene that is put together on the page: its objects, what may be done to them, undone and asked for. Logic without a browser.
import { conjugate, multiply, rotate } from "./hand.js";

const MOST_STEPS = 100; // that can be undone

/// objects   [{source, name, unit, position [m], quaternion, friction, mass, density: null where the scene leaves it open,
///            size: longest side [m], 0 where it is not known}], the first in the hand
export function makeComposition() {
  return { title: "", objects: [], undone: [], done: [], chosen: 0 };
}

/// What a `scene` message says, as objects.
export function objectsOf(scene) {
  const one = (body, pose) => ({ source: body.source ?? null, name: body.name, unit: body.unit ?? 1, position: [...pose.position], quaternion: [...pose.quat_xyzw],
    friction: body.friction ?? null, mass: body.mass ?? null, density: body.density ?? null, size: 2 * body.radius });
  return [one(scene.object, scene.start), ...scene.statics.map((body) => one(body, body))];
}

/// The scene has become what a message says. What could be undone stays where that is what was asked for.
export function takeScene(composition, scene, isOwn) {
  Object.assign(composition, { title: scene.title, objects: objectsOf(scene) });
  composition.chosen = Math.min(composition.chosen, composition.objects.length - 1);
  if (!isOwn) Object.assign(composition, { done: [], undone: [] });
}

/// Every edit gives the objects as they would be; commit makes them so, with the old ones kept.
export function commit(composition, objects) {
  composition.done.push(composition.objects);
  composition.done.splice(0, composition.done.length - MOST_STEPS);
  Object.assign(composition, { objects, undone: [] });
}
export function undo(composition) { return turnBack(composition, composition.done, composition.undone); }
export function redo(composition) { return turnBack(composition, composition.undone, composition.done); }
function turnBack(composition, from, to) {
  if (from.length === 0) return false;
  to.push(composition.objects);
  composition.objects = from.pop();
  composition.chosen = Math.min(composition.chosen, composition.objects.length - 1);
  return true;
}
/// The program has refused what was committed last.
export function revert(composition) {
  if (composition.done.length > 0) composition.objects = composition.done.pop();
  composition.chosen = Math.min(composition.chosen, composition.objects.length - 1);
}

export const changed = (objects, index, what) => objects.map((one, k) => (k === index ? { ...one, ...what } : one));
export const without = (objects, index) => objects.filter((_, k) => k !== index);
/// Another object comes into the hand; the one that was there stands still, where it is.
export const inHand = (objects, index) => [objects[index], ...without(objects, index)];

/// A mesh that was dropped (`model` message), beside what is there. usual unit that of the message.
export function added(objects, model, unit, scene) {
  const { min, max } = model.report.bounds;
  const middle = min.map((low, k) => 0.5 * unit * (low + max[k])), size = min.map((low, k) => unit * (max[k] - low));
  const right = Math.max(...boundsOf(objects, scene).map(({ center, radius }) => center[0] + radius), -Infinity);
  const gap = 0.1 * Math.max(...size);
  const position = [(Number.isFinite(right) ? right + gap + 0.5 * size[0] : 0) - middle[0], -middle[1], -middle[2]];
  return [...objects, { source: `file:${model.number}`, name: stem(model.name), unit, position, quaternion: [0, 0, 0, 1], friction: null, mass: null,
    density: null, size: Math.max(...size) }];
}
const stem = (name) => name.replace(/\.[^.]*$/, "") || name;

/// Balls of the objects that are shown.
function boundsOf(objects, scene) {
  const bodies = scene ? [scene.object, ...scene.statics] : [];
  return objects.map((one, k) => {
    const body = bodies[k];
    const center = body ? rotate(one.quaternion, body.center).map((value, i) => value + one.position[i]) : one.position;
    return { center, radius: body?.radius ?? 0.5 * one.size };
  });
}

/// `compose` for the program.
export function composeMessage({ title, objects }) {
  return { type: "compose", title, objects: objects.map(({ source, name, unit, position, quaternion, friction, mass, density }, k) => ({ source, name, unit, position,
    quat_xyzw: quaternion, friction, ...(k === 0 ? { mass, density } : {}) })) };
}

/// Turns about z, then y, then x of the world [degrees], and back; of a turn by 90 degrees about y one of many.
export function toAngles([x, y, z, w]) {
  const sine = Math.max(-1, Math.min(1, 2 * (w * y - z * x))), degrees = 180 / Math.PI;
  if (Math.abs(sine) > 1 - 1e-9) return [0, Math.sign(sine) * 90, -2 * Math.sign(sine) * Math.atan2(x, w) * degrees];
  return [Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)) * degrees, Math.asin(sine) * degrees,
    Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)) * degrees];
}
export function fromAngles(angles) {
  const [x, y, z] = angles.map((angle, k) => {
    const half = (angle * Math.PI) / 360, q = [0, 0, 0, Math.cos(half)];
    q[k] = Math.sin(half);
    return q;
  });
  return multiply(z, multiply(y, x));
}

/// How far two directions are apart [rad].
export const angleBetween = (a, b) => 2 * Math.acos(Math.min(1, Math.abs(multiply(conjugate(a), b)[3])));
