import assert from "node:assert/strict";
import { test } from "node:test";
import { FAST, makePace, notePicture, restAfter, SLOW, STEPS } from "../../src/pace.js";

/// Draws n pictures that take seconds(step) each; the steps it went through.
function drawMany(pace, n, seconds) {
  const steps = [pace.step];
  for (let k = 0; k < n; k++) if (notePicture(pace, seconds(pace.step, k))) steps.push(pace.step);
  return steps;
}

test("slow pictures become simpler, down to the last step and no further", () => {
  const pace = makePace();
  const steps = drawMany(pace, 1000, () => 3 * SLOW);
  assert.deepEqual(steps, STEPS.map((_, k) => k));
  for (let k = 1; k < STEPS.length; k++) {
    assert.ok(STEPS[k].ratio <= STEPS[k - 1].ratio && (STEPS[k - 1].shadows || !STEPS[k].shadows), `step ${k} is not simpler`);
  }
});

test("fast ones become whole again, and what lies between stays", () => {
  assert.equal(drawMany(makePace({ step: 3 }), 5000, () => 0.5 * FAST).at(-1), 0);
  assert.deepEqual(drawMany(makePace({ step: 2 }), 5000, () => 0.5 * (FAST + SLOW)), [2]);
});

test("what a change costs, or one slow picture among fast ones, is no reason", () => {
  assert.deepEqual(drawMany(makePace(), 1000, (_, k) => (k < 2 ? 20 * SLOW : k % 50 === 49 ? 3 * SLOW : 0.5 * FAST)), [0]);
});

test("between one step that is too slow and one that is fast it changes less and less often", () => {
  const pace = makePace({ step: 2 });
  const early = drawMany(pace, 1000, (step) => (step < 2 ? 2 * SLOW : 0.5 * FAST)).length;
  const late = drawMany(pace, 10000, (step) => (step < 2 ? 2 * SLOW : 0.5 * FAST)).length;
  assert.ok(early > 2 && late <= early, `${early} changes, then ${late} in ten times as many pictures`);
});

test("a fixed one stays; a picture that is felt leaves as much time as it took", () => {
  assert.deepEqual(drawMany(makePace({ fixed: true }), 100, () => 9 * SLOW), [0]);
  assert.equal(restAfter(0.5 * FAST, false), 0);
  assert.equal(restAfter(0.5 * FAST, true), 0.5 * FAST);
  assert.equal(restAfter(2 * SLOW, false), 2 * SLOW);
});
