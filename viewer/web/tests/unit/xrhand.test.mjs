import assert from "node:assert/strict";
import { test } from "node:test";
import { aboutAxis, makeHand, rotate } from "../../src/hand.js";
import { makeRoom, makeXrHand, stepXrHand } from "../../src/xrhand.js";

const PLAIN = { position: [0, 0, 0], quat_xyzw: [0, 0, 0, 1], motion_scale: 1, force_scale: 1 };
const AT = { position: [0.1, -0.2, -0.4], quaternion: aboutAxis([0, 0.6, 0.8], 0.7) };
const NORTH = -Math.PI / 2; // azimuth of who looks along +y: right is +x, up is +z
const close = (a, b, off = 1e-12) => a.forEach((value, k) => assert.ok(Math.abs(value - b[k]) < off, `${a} is not ${b}`));
const same = (a, b) => assert.ok(Math.abs(Math.abs(a.reduce((sum, value, k) => sum + value * b[k], 0)) - 1) < 1e-12, `${a} does not turn as ${b}`);

/// Takes hold at one pose of the grip, moves to another; the hand then.
function moved(room, workspace, from, to, free = false) {
  const xr = makeXrHand(), hand = makeHand(), right = {};
  const at = (pose, more = {}) => [{ source: right, grabs: true, free: false, pose, ...more }];
  assert.equal(stepXrHand(xr, at(from), room, hand, workspace), "press");
  hand.clutch = true;
  assert.equal(stepXrHand(xr, at(to, { free }), room, hand, workspace), null);
  return hand;
}
const by = (way) => ({ position: AT.position.map((value, k) => value + way[k]), quaternion: AT.quaternion });
function turnedBy(q) {
  const [a, b] = [q, AT.quaternion];
  return { position: AT.position, quaternion: [a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
    a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]] };
}

// What a person does, and what it is in the world for one who looks along +y, and along -x: no sign and no axis is swapped.
const TABLE = [
  ["to the right", [1, 0, 0], [1, 0, 0], [0, 1, 0]],
  ["up", [0, 1, 0], [0, 0, 1], [0, 0, 1]],
  ["towards oneself", [0, 0, 1], [0, -1, 0], [1, 0, 0]],
];

test("six poses: three ways and three turns of the grip are those of the world, right-handed", () => {
  for (const [azimuth, column] of [[NORTH, 2], [0, 3]]) {
    const room = makeRoom(azimuth, 0.25, 0.05);
    for (const row of TABLE) {
      const [, way, axis] = [row[0], row[1], row[column]];
      close(moved(room, PLAIN, AT, by(way.map((value) => 0.1 * value))).position, axis.map((value) => 0.1 * 0.2 * value));
      const hand = moved(room, PLAIN, AT, turnedBy(aboutAxis(way, 0.3)));
      same(hand.quaternion, aboutAxis(axis, 0.3));
      close(hand.position, [0, 0, 0]);
    }
    const [x, y, z] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis) => rotate(room.turn, axis));
    const cross = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
    close(cross, z);
  }
});

test("one centimetre in the room is one of the picture there, whatever the workspace", () => {
  const workspace = { ...PLAIN, quat_xyzw: aboutAxis([0, 0, 1], Math.PI / 2), motion_scale: 2 };
  for (const [shown, radius] of [[0.25, 0.05], [1, 0.05], [0.25, 12]]) {
    const hand = moved(makeRoom(NORTH, shown, radius), workspace, AT, by([0.01, 0, 0]));
    close(rotate(workspace.quat_xyzw, hand.position).map((value) => value * 2), [(0.01 * radius) / shown, 0, 0]);
  }
  const tiny = makeRoom(0, 1e-9, 1), huge = makeRoom(0, 1e9, 1);
  assert.ok(tiny.shown > 0.01 && huge.shown < 5);
});

test("squeezing frees the controller: it goes, the hand stays", () => {
  const hand = moved(makeRoom(NORTH, 0.25, 0.05), PLAIN, AT, by([0.1, 0.1, 0.1]), true);
  assert.deepEqual([hand.position, hand.quaternion], [[0, 0, 0], [0, 0, 0, 1]]);
});

/// Steps of {grabs, pose, clutch} of one controller; what each did.
function run(steps) {
  const xr = makeXrHand(), hand = makeHand(), right = {}, room = makeRoom(0, 0.25, 0.05);
  return steps.map(({ grabs, pose, clutch, gone }) => {
    if (clutch !== undefined) hand.clutch = clutch;
    return stepXrHand(xr, gone ? [] : [{ source: right, grabs, free: false, pose }], room, hand, PLAIN);
  });
}

test("what is not tracked or gone lets go, and only a new press takes hold again", () => {
  const hold = [{ grabs: true, pose: AT }, { grabs: true, pose: AT, clutch: true }];
  for (const loss of [{ grabs: true, pose: null }, { gone: true }]) {
    assert.deepEqual(run([...hold, loss, { grabs: true, pose: AT }, { grabs: false, pose: AT, clutch: false }, { grabs: true, pose: AT }]),
      ["press", null, "letGo", null, null, "press"]);
  }
  assert.deepEqual(run([{ grabs: true, pose: null }, { grabs: true, pose: AT }]), [null, null], "pressed while not tracked");
  assert.deepEqual(run([...hold, { grabs: false, pose: AT }]), ["press", null, "letGo"]);
  assert.deepEqual(run([...hold, { grabs: true, pose: AT, clutch: false }, { grabs: true, pose: AT }]), ["press", null, "letGo", null],
    "after a fault, too, it takes a new press");
  assert.deepEqual(run([{ grabs: true, pose: AT }, { grabs: true, pose: AT }, { grabs: true, pose: AT, clutch: true }]), ["press", null, null],
    "the answer of the program may take its time");
});
