// A second device that moves the view.
import { test } from "node:test";
import assert from "node:assert/strict";
import { axes, follow, makeView } from "../../src/camera.js";

const still = { position: [0, 0, 0], quat_xyzw: [0, 0, 0, 1] };
const at = (position, quat_xyzw = still.quat_xyzw) => ({ position, quat_xyzw });
const turned = (axis, angle) => at([0, 0, 0], [...[0, 1, 2].map((k) => (k === axis ? Math.sin(angle / 2) : 0)), Math.cos(angle / 2)]);

function moved(to) {
  const view = makeView();
  follow(view, at([0.2, -0.1, 0.3])); // where it begins means nothing
  follow(view, null);
  follow(view, still);
  const before = { ...view, target: view.target.clone(), way: axes(view) };
  follow(view, to);
  return { view, before };
}

test("the scene goes with what is pushed", () => {
  const right = moved(at([0, 0.01, 0]));
  const way = right.view.target.clone().sub(right.before.target);
  assert.ok(Math.abs(way.dot(right.before.way.right) + 0.05 * right.before.distance) < 1e-12); // the target goes to the left
  assert.ok(Math.abs(way.dot(right.before.way.up)) < 1e-12);
  const up = moved(at([0, 0, 0.01]));
  assert.ok(up.view.target.clone().sub(up.before.target).dot(up.before.way.up) < 0);
  const nearer = moved(at([0.01, 0, 0]));
  assert.ok(Math.abs(nearer.view.distance - nearer.before.distance * Math.exp(-0.05)) < 1e-12);
});

test("it turns with what is turned, whichever sign the quaternion has", () => {
  for (const sign of [1, -1]) {
    const about = (axis) => { const pose = turned(axis, 0.02); pose.quat_xyzw = pose.quat_xyzw.map((value) => sign * value); return moved(pose); };
    const up = about(2);
    assert.ok(Math.abs(up.view.azimuth - up.before.azimuth + 0.02) < 1e-6);
    const right = about(1);
    assert.ok(Math.abs(right.view.elevation - right.before.elevation - 0.02) < 1e-6);
    const roll = about(0);
    assert.equal(roll.view.azimuth, roll.before.azimuth); // up stays up
    assert.equal(roll.view.elevation, roll.before.elevation);
  }
});

test("one way there and back is the same view", () => {
  const view = makeView();
  follow(view, still);
  const before = { azimuth: view.azimuth, elevation: view.elevation, distance: view.distance };
  follow(view, at([0.01, 0, 0], turned(2, 0.03).quat_xyzw));
  follow(view, still);
  for (const key of Object.keys(before)) assert.ok(Math.abs(view[key] - before[key]) < 1e-12, key);
});
