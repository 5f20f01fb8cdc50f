import assert from "node:assert/strict";
import { test } from "node:test";
import { soundOf } from "../../src/sound.js";

const rows = (n, begin, force) => Array.from({ length: n }, (_, k) => ({ time: begin + k / 1000, force: force(k) }));
const loudest = (samples) => samples.reduce((most, value) => Math.max(most, Math.abs(value)), 0);

test("a steady press is silent, a tap is heard when it comes, and never louder than full", () => {
  assert.equal(loudest(soundOf(rows(50, 0, () => 2), null, 3.3).samples), 0);
  const { samples } = soundOf(rows(50, 0, (k) => (k < 20 ? 0 : 2)), null, 3.3);
  const first = samples.findIndex((value) => value !== 0) / 8000;
  assert.ok(first > 0.0185 && first < 0.0205, `${first} s`);
  assert.ok(loudest(samples) <= 1 && loudest(samples) > 0.5);
  assert.ok(loudest(soundOf(rows(50, 0, (k) => (k < 20 ? 0 : 0.02)), null, 3.3).samples) < 0.1, "a light touch is soft");
});

test("batches follow each other without a gap, and what is not known is silent", () => {
  const wave = (k) => 1 + 0.2 * Math.sin(0.9 * k);
  const whole = soundOf(rows(60, 0, wave), null, 3.3).samples;
  const one = soundOf(rows(30, 0, wave), null, 3.3);
  const two = soundOf(rows(30, 0.03, (k) => wave(k + 30)), one.last, 3.3);
  assert.ok(Math.abs(one.samples.length + two.samples.length - whole.length) <= 1);
  assert.ok(Math.abs(two.samples[100] - whole[one.samples.length + 100]) < 1e-6);
  assert.equal(soundOf([], null, 3.3).samples.length, 0);
  assert.equal(soundOf(rows(2, 0, () => NaN), null, 3.3).samples.every((value) => value === 0), true);
  assert.equal(soundOf(rows(2, 9, () => 1), { time: 1, force: 1 }, 3.3).samples.length, 0, "after a pause it begins anew");
});
