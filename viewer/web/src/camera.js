// Where one looks from: turned, moved and zoomed about a target, z always up. Display units: the scene has radius 1.
import { PerspectiveCamera, Quaternion, Vector3 } from "three";

export function makeView() {
  const view = { camera: new PerspectiveCamera(30, 1, 0.01, 100), target: new Vector3(), home: null,
    azimuth: 0.75, elevation: 0.40, distance: 4.2, changed: true, pushed: null };
  view.home = { azimuth: view.azimuth, elevation: view.elevation, distance: view.distance };
  placeCamera(view);
  return view;
}

export function placeCamera(view) {
  const level = view.distance * Math.cos(view.elevation);
  view.camera.up.set(0, 0, 1);
  view.camera.position.set(
    view.target.x + level * Math.cos(view.azimuth),
    view.target.y + level * Math.sin(view.azimuth),
    view.target.z + view.distance * Math.sin(view.elevation));
  view.camera.lookAt(view.target);
  view.camera.updateMatrixWorld();
  view.changed = true;
}

export function orbit(view, dx, dy) {
  view.azimuth -= 0.006 * dx;
  view.elevation = Math.max(-1.5, Math.min(1.5, view.elevation + 0.006 * dy));
  placeCamera(view);
}

/// Looks at the target from a direction of the world, as far away as before.
export function lookFrom(view, [x, y, z]) {
  view.azimuth = x === 0 && y === 0 ? -Math.PI / 2 : Math.atan2(y, x); // from above x goes right and y up
  view.elevation = Math.max(-1.5, Math.min(1.5, Math.atan2(z, Math.hypot(x, y))));
  placeCamera(view);
}

/// factor   above 1: farther away
export function zoom(view, factor) {
  view.distance = Math.max(0.3, Math.min(30, view.distance * factor));
  placeCamera(view);
}

/// Moves the target with the pointer; dx, dy in pixels, height that of the picture.
export function pan(view, dx, dy, height) {
  const { right, up } = axes(view);
  const size = unitsPerPixel(view, view.distance, height);
  view.target.addScaledVector(right, -dx * size).addScaledVector(up, dy * size);
  placeCamera(view);
}

const PUSH = 5; // a metre of a second device's way is so many distances to the target

/// Moves the view as the handle of a second device has moved since it was told last: the scene goes and turns with it.
/// pose   {position [m], quat_xyzw}, x to the person, y right, z up; null: what is told next begins anew
export function follow(view, pose) {
  const before = view.pushed;
  view.pushed = pose;
  if (!before || !pose) return;
  const [nearer, right, up] = pose.position.map((value, k) => PUSH * (value - before.position[k]));
  const from = new Quaternion(...before.quat_xyzw), turn = new Quaternion(...pose.quat_xyzw).multiply(from.invert());
  const twice = turn.w < 0 ? -2 : 2; // small turns: twice the vector's part
  const way = axes(view);
  view.target.addScaledVector(way.right, -right * view.distance).addScaledVector(way.up, -up * view.distance);
  view.distance = Math.max(0.3, Math.min(30, view.distance * Math.exp(-nearer)));
  view.azimuth -= twice * turn.z;
  view.elevation = Math.max(-1.5, Math.min(1.5, view.elevation + twice * turn.y));
  placeCamera(view);
}

export function goHome(view) {
  Object.assign(view, view.home);
  view.target.set(0, 0, 0);
  placeCamera(view);
}

/// Unit vectors of the picture in the world: right, up, and forward into the screen.
export function axes(view) {
  const right = new Vector3(), up = new Vector3(), back = new Vector3();
  view.camera.matrixWorld.extractBasis(right, up, back);
  return { right, up, forward: back.negate() };
}

/// Length one pixel covers at a distance in front of the camera.
export function unitsPerPixel(view, distance, height) {
  return (2 * Math.tan((view.camera.fov * Math.PI) / 360) * distance) / Math.max(1, height);
}

/// Distance of a point in front of the camera, never behind it.
export function depthOf(view, point) {
  const { forward } = axes(view);
  return Math.max(0.05, point.clone().sub(view.camera.position).dot(forward));
}
