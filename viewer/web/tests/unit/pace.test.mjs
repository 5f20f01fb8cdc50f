import assert from "node:assert/strict";
import { test } from "node:test";
import { FAST, LONGEST, makePace, notePicture, PLAIN_STEP, restAfter, SLOW, STEPS } from "../../src/pace.js";

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
    const [a, b] = [STEPS[k - 1], STEPS[k]];
    assert.ok(b.pixels <= a.pixels && (a.shadows || !b.shadows) && (a.rich || !b.rich) && b.off >= a.off, `step ${k} is not simpler`);
  }
  assert.ok(STEPS.every(({ pixels }) => pixels >= 1), "the view always has its full size");
  assert.ok(STEPS.slice(PLAIN_STEP).every(({ rich, shadows }) => !rich && !shadows), "what the processor draws is plain");
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

test("a fixed one stays; what the processor draws leaves time to the others, and comes fifteen times a second where that can be", () => {
  assert.deepEqual(drawMany(makePace({ fixed: true }), 100, () => 9 * SLOW), [0]);
  assert.equal(restAfter(0.5 * SLOW, false), 0, "graphics hardware takes nothing from the engine");
  assert.equal(restAfter(0.01, true), 0.01, "as long as it took");
  for (let took = 0.005; took <= SLOW; took += 0.005) assert.ok(took + restAfter(took, true) <= LONGEST, `${took} s`);
  for (const plain of [false, true]) assert.equal(restAfter(4 * SLOW, plain), SLOW);
});
