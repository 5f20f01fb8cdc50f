import assert from "node:assert/strict";
import { test } from "node:test";
import { coarsestWithin, levelAtHand, levelToDraw, patchBalls, reachPatches } from "../../src/detail.js";

const LIST = [{ free: false, triangles: 10000, deviation: 0 }, { free: false, triangles: 3000, deviation: 1e-4 },
  { free: true, triangles: 0, deviation: null }, { free: false, triangles: 800, deviation: 4e-4 }, { free: false, triangles: 900, deviation: 5e-4 }];

test("the coarsest level is drawn that is nowhere farther off than asked, free ones never", () => {
  const at = (metres, pixels) => levelToDraw(LIST, metres, pixels);
  assert.equal(at(1e-4, 0), 0, "nothing but the original");
  assert.equal(at(1e-4, 0.9), 0);
  assert.equal(at(1e-4, 1), 1);
  assert.equal(at(1e-4, 4), 3);
  assert.equal(at(1, 1), 3, "of those allowed the one with the fewest triangles");
  assert.equal(at(1e-9, 1), 0, "from near by everything");
  assert.equal(levelToDraw(undefined, 1, 1), 0);
});

test("until a level is here the next finer one is drawn", () => {
  const here = new Set([1, 2]);
  assert.equal(levelAtHand(3, (level) => here.has(level)), 2);
  assert.equal(levelAtHand(1, (level) => here.has(level)), 1);
  assert.equal(levelAtHand(3, () => false), 0);
});

test("of what is made for drawing alone the coarsest is drawn that is near enough, else the original", () => {
  const list = [1, 2, 4].map((deviation) => ({ deviation }));
  assert.deepEqual([0, 0.9, 1, 3, 4, Infinity].map((allowed) => coarsestWithin(list, allowed)), [0, 0, -1, -2, -3, -3]);
  assert.equal(coarsestWithin([], 1), 0);
});

test("a spot reaches the patches whose points come near it, against every point", () => {
  let seed = 5;
  const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
  const patches = 30, positions = [], labels = [];
  for (let p = 0; p < patches; p++) {
    const centre = [random(), random(), random()];
    for (let k = 0; k < 6; k++) { positions.push(...centre.map((c) => c + 0.1 * random())); labels.push(p === 7 ? -1 : p); }
  }
  const balls = patchBalls(positions, labels, patches), into = new Uint8Array(patches);
  let reached = 0;
  for (let trial = 0; trial < 40; trial++) {
    const point = [random(), random(), random()], reach = 0.2 * random();
    reachPatches(balls, [{ point }], reach, into);
    for (let v = 0; v < labels.length; v++) {
      if (labels[v] >= 0 && Math.hypot(...[0, 1, 2].map((k) => positions[3 * v + k] - point[k])) < reach) {
        assert.equal(into[labels[v]], 255, "no point in reach is missed");
        reached += 1;
      }
    }
    assert.equal(into[7], 0, "a patch without points is nowhere");
    for (let p = 0; p < patches; p++) {
      if (into[p] === 0) continue;
      const gap = Math.hypot(...[0, 1, 2].map((k) => balls[4 * p + k] - point[k]));
      assert.ok(gap < reach + 0.1 * Math.sqrt(3) / 2 + 1e-6, "and none far away is taken");
    }
  }
  assert.ok(reached > 20);
});
