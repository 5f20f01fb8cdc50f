import assert from "node:assert/strict";
import { test } from "node:test";
import { roundLength } from "../../src/geometry.js";
import { fullScales, sayIn, shareOf, steadyUnit } from "../../src/steady.js";

test("a tile keeps the unit of its limit, whatever the value", () => {
  const force = steadyUnit(3.3, "N"), torque = steadyUnit(0.1, "N m"), stretch = steadyUnit(0.0066, "m"), depth = steadyUnit(4e-4, "m");
  assert.deepEqual([force.unit, torque.unit, stretch.unit, depth.unit], ["N", "mN m", "mm", "µm"]);
  assert.deepEqual([0, 0.0123, 1, 3.3, 12].map((value) => sayIn(value, force)), ["0.00", "0.01", "1.00", "3.30", "12.0"]);
  assert.deepEqual([0.0024, 0.1].map((value) => sayIn(value, torque)), ["2.4", "100"]);
  assert.deepEqual([5.5012e-4, 9.994e-5, 9.996e-5, 9.99e-6].map((value) => sayIn(value, depth)), ["550", "99.9", "100", "10.0"]);
  for (let value = 1e-6; value < 9.99e-4; value *= 1.003) assert.ok(sayIn(value, depth).length <= 4, "no wider than its tile");
  assert.equal(sayIn(2, depth), "2000000", "no digits that say nothing");
  for (const unknown of [NaN, null, undefined, Infinity]) assert.equal(sayIn(unknown, force), "–");
  assert.equal(steadyUnit(NaN, "N").unit, "N");
});

test("limits are those of the hand, or what gives its largest force", () => {
  const scene = { workspace: { force_scale: 0.5 }, tolerance: 4e-4 };
  const springs = [{ name: "coupling_stiffness", value: 500 }, { name: "contact_stiffness", value: 2000 }];
  assert.deepEqual(fullScales({ force: 2, torque: 0.05 }, springs, scene), { force: 2, torque: 0.05, stretch: 4 / 500, penetration: 4 / 2000 });
  const unknown = fullScales(null, [], scene);
  assert.ok(unknown.force > 0 && unknown.torque > 0 && unknown.stretch > 0 && unknown.penetration === 4e-4);
  assert.equal(fullScales({ force: 2, torque: null }, springs, scene).torque, unknown.torque);
  assert.deepEqual([shareOf(1, 4), shareOf(-1, 4), shareOf(9, 4), shareOf(NaN, 4), shareOf(1, 0)], [0.25, 0.25, 1, 0, 0]);
});

test("bars are as long as a round number, and never longer than asked", () => {
  assert.deepEqual([1, 1.9, 2, 4.9, 5, 9.9, 0.073].map((most) => Number(roundLength(most).toPrecision(6))), [1, 1, 2, 2, 5, 5, 0.05]);
  for (let most = 1e-9; most < 1e6; most *= 1.37) {
    const length = roundLength(most);
    assert.ok(length <= most * (1 + 1e-8) && length > 0.39 * most, `${most}: ${length}`);
  }
});
