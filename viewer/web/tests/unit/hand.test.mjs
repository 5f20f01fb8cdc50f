import assert from "node:assert/strict";
import { test } from "node:test";
import { aboutAxis, makeHand, moveHand, multiply, noteSample, poseOf, rotate, takeSamples, turnHand } from "../../src/hand.js";

const close = (a, b) => a.forEach((value, k) => assert.ok(Math.abs(value - b[k]) < 1e-12, `${a} is not ${b}`));
const PLAIN = { quat_xyzw: [0, 0, 0, 1], motion_scale: 1 };

test("rotations are right-handed", () => {
  close(rotate(aboutAxis([0, 0, 1], Math.PI / 2), [1, 0, 0]), [0, 1, 0]);
  const a = aboutAxis([0, 0, 1], 0.3), b = aboutAxis([1, 0, 0], 0.7);
  close(rotate(multiply(a, b), [1, 2, 3]), rotate(a, rotate(b, [1, 2, 3])));
});

test("a way in the world becomes R^T d / scale in the device", () => {
  const workspace = { quat_xyzw: aboutAxis([0, 0, 1], Math.PI / 2), motion_scale: 2 };
  const hand = makeHand();
  moveHand(hand, [0, 0.4, 0], workspace);
  close(hand.position, [0.2, 0, 0]);
  close(rotate(workspace.quat_xyzw, hand.position).map((x) => x * 2), [0, 0.4, 0]);
});

test("a turn about an axis of the world is that turn, seen from the device", () => {
  const workspace = { quat_xyzw: aboutAxis([0, 0, 1], Math.PI / 2), motion_scale: 1 };
  const hand = makeHand();
  for (let k = 0; k < 1000; k++) turnHand(hand, [0, 1, 0], 0.001, workspace);
  close(hand.quaternion, aboutAxis([1, 0, 0], 1));
  assert.ok(Math.abs(Math.hypot(...hand.quaternion) - 1) < 1e-12);
});

test("positions stay where the program takes them", () => {
  const hand = makeHand();
  moveHand(hand, [1e6, -1e6, 0], PLAIN);
  assert.ok(Math.abs(hand.position[0]) < 10 && Math.abs(hand.position[1]) < 10);
});

test("at most 250 samples a second, and the newest position always", () => {
  const hand = makeHand();
  let sent = [];
  for (let k = 0; k < 1000; k++) {
    hand.position = [k, 0, 0];
    noteSample(hand, k / 1000);
    if (k % 16 === 15) sent = sent.concat(takeSamples(hand));
  }
  sent = sent.concat(takeSamples(hand));
  assert.ok(sent.length <= 330 && sent.length > 150, `${sent.length} samples`);
  assert.equal(sent[sent.length - 1].position[0], 999);
  for (let k = 1; k < sent.length; k++) assert.ok(sent[k].time >= sent[k - 1].time);
});

test("a press is never swallowed", () => {
  const hand = makeHand();
  noteSample(hand, 1);
  hand.clutch = true;
  noteSample(hand, 1);
  hand.clutch = false;
  noteSample(hand, 1.0001);
  assert.deepEqual(takeSamples(hand).map((sample) => sample.buttons), [0, 1, 0]);
});

test("the clock never falls, and a message holds no more than it may", () => {
  const hand = makeHand();
  noteSample(hand, 5);
  noteSample(hand, 4);
  for (let k = 0; k < 300; k++) noteSample(hand, 6 + k / 100);
  const samples = takeSamples(hand);
  assert.equal(samples.length, 64);
  assert.ok(samples.every((sample, k) => k === 0 || sample.time >= samples[k - 1].time));
  assert.deepEqual(takeSamples(hand), []);
});

test("where the hand was when it was pressed is told before where it has got to", () => {
  const hand = makeHand();
  const from = poseOf(hand);
  moveHand(hand, [0.1, 0, 0], PLAIN);
  noteSample(hand, 1, from);
  hand.clutch = true;
  noteSample(hand, 1);
  assert.deepEqual(takeSamples(hand).map(({ position, buttons }) => [position[0], buttons]), [[0, 0], [0.1, 1]]);
});
