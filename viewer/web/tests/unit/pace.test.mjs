import assert from "node:assert/strict";
import { test } from "node:test";
import { beginAgain, isFast, makePace, notePicture, PLAIN_STEP, restAfter, SLOW, STEPS } from "../../src/pace.js";

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

const QUICK = 0.1 * SLOW; // fast at every step

test("fast ones become whole again, and what lies between stays", () => {
  assert.ok(STEPS.every((_, step) => step === 0 || isFast(step, QUICK)) && !isFast(0, 0.01));
  assert.equal(drawMany(makePace({ step: 3 }), 5000, () => QUICK).at(-1), 0);
  assert.deepEqual(drawMany(makePace({ step: 2 }), 5000, () => 0.5 * SLOW), [2]);
  // A step is given up for the one before only where that is likely to be fast enough.
  assert.deepEqual(drawMany(makePace({ step: 5 }), 5000, (step) => [0.9, 0.45, 0.24, 0.15, 0.04, 0.025][step]), [5, 4]);
});

test("coarser surfaces that have come are drawn as fine as may be, and the rest stays", () => {
  const pace = makePace({ step: PLAIN_STEP });
  drawMany(pace, 100, () => 2 * SLOW);
  beginAgain(pace);
  assert.equal(pace.step, PLAIN_STEP);
  assert.deepEqual(drawMany(pace, 2, () => 9 * SLOW), [PLAIN_STEP], "what the change costs counts for nothing");
  const hardware = makePace();
  drawMany(hardware, 100, () => 2 * SLOW);
  beginAgain(hardware);
  assert.ok(STEPS[hardware.step].off > 0 && STEPS[hardware.step - 1].off === 0, "where they are drawn at all");
  const fast = makePace(), fixed = makePace({ step: 5, fixed: true });
  beginAgain(fast);
  beginAgain(fixed);
  assert.deepEqual([fast.step, fixed.step], [0, 5]);
});

test("what a change costs, or one slow picture among fast ones, is no reason", () => {
  assert.deepEqual(drawMany(makePace(), 1000, (_, k) => (k < 2 ? 20 * SLOW : k % 50 === 49 ? 3 * SLOW : QUICK)), [0]);
});

test("between one step that is too slow and one that is fast it changes less and less often", () => {
  const pace = makePace({ step: 2 });
  const early = drawMany(pace, 1000, (step) => (step < 2 ? 2 * SLOW : QUICK)).length;
  const late = drawMany(pace, 10000, (step) => (step < 2 ? 2 * SLOW : QUICK)).length;
  assert.ok(early > 2 && late <= early, `${early} changes, then ${late} in ten times as many pictures`);
});

test("a fixed one stays; what the processor draws leaves time to the others, and comes fifteen times a second where that can be", () => {
  assert.deepEqual(drawMany(makePace({ fixed: true }), 100, () => 9 * SLOW), [0]);
  assert.equal(restAfter(0.5 * SLOW, false), 0, "graphics hardware takes nothing from the engine");
  assert.equal(restAfter(0.01, true), 0.01, "as long as it took");
  for (let took = 0.005; took <= SLOW; took += 0.005) assert.ok(took + restAfter(took, true) <= 1 / 15, `${took} s`);
  for (const plain of [false, true]) assert.equal(restAfter(4 * SLOW, plain), SLOW);
});
