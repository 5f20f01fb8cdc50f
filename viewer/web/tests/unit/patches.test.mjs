import assert from "node:assert/strict";
import { test } from "node:test";
import { groupsAtLevel, markCovered, markPatches, patchLabels, patchRanges, tint, trianglesByPatch } from "../../src/patches.js";
import { NOTHING } from "../../src/protocol.js";

// 6 is the root of 4 and 5; 4 has leaves 0 and 1, 5 has 2 and 3. Patches lie on leaves in another order.
const PARENTS = Int32Array.from([4, 4, 5, 5, 6, 6, -1]);
const NODES = Int32Array.from([3, 1, 0, 2]);
const below = (ranges, node) => [...ranges.order.slice(ranges.begin[node], ranges.end[node])].sort();

test("every node has the patches below it", () => {
  const ranges = patchRanges(NODES, PARENTS);
  assert.deepEqual([0, 1, 2, 3].map((node) => below(ranges, node)), [[2], [1], [3], [0]]);
  assert.deepEqual(below(ranges, 4), [1, 2]);
  assert.deepEqual(below(ranges, 5), [0, 3]);
  assert.deepEqual(below(ranges, 6), [0, 1, 2, 3]);
});

test("several roots, inner nodes with patches of their own, nodes without any", () => {
  const ranges = patchRanges(Int32Array.from([1, 0, 1]), Int32Array.from([1, -1, -1]));
  assert.deepEqual(below(ranges, 1), [0, 1, 2]);
  assert.deepEqual(below(ranges, 0), [1]);
  assert.deepEqual(below(ranges, 2), []);
});

test("against walking up from every patch, in random forests", () => {
  let seed = 7;
  const random = (n) => (seed = (seed * 16807) % 2147483647) % n;
  for (let trial = 0; trial < 50; trial++) {
    const N = 1 + random(40), P = random(60);
    const parents = Int32Array.from({ length: N }, (_, k) => (k === N - 1 || random(9) === 0 ? -1 : k + 1 + random(N - 1 - k)));
    const nodes = Int32Array.from({ length: P }, () => random(N));
    const ranges = patchRanges(nodes, parents);
    for (let node = 0; node < N; node++) {
      const expected = [];
      for (let patch = 0; patch < P; patch++) {
        for (let up = nodes[patch]; up >= 0; up = parents[up]) if (up === node) expected.push(patch);
      }
      assert.deepEqual(below(ranges, node), expected.sort());
    }
  }
});

test("a circle of parents is refused", () => {
  assert.throws(() => patchRanges(Int32Array.from([0]), Int32Array.from([1, 0])), RangeError);
});

test("the finer level wins where contacts meet, and old marks go", () => {
  const ranges = patchRanges(NODES, PARENTS);
  const into = new Uint8Array(4).fill(9);
  markPatches(ranges, [{ node: 6, level: 2 }, { node: 1, level: 0 }, { node: 5, level: 1 }, { node: 99, level: 0 }, { node: -1, level: 0 }], into);
  assert.deepEqual([...into], [2, 1, 3, 2]);
  markPatches(ranges, [], into);
  assert.deepEqual([...into], [0, 0, 0, 0]);
});

test("patches of a level go by the coarsest node that is not coarser", () => {
  //        6 (2)
  //    4 (1)   5 (1)
  //  0   1    2   3
  const parents = [4, 4, 5, 5, 6, 6, -1], levels = [0, 0, 0, 0, 1, 1, 2];
  assert.deepEqual([...groupsAtLevel([0, 1, 2, 3], parents, levels, 0)], [0, 1, 2, 3]);
  assert.deepEqual([...groupsAtLevel([0, 1, 2, 3], parents, levels, 1)], [4, 4, 5, 5]);
  assert.deepEqual([...groupsAtLevel([0, 1, 2, 3], parents, levels, 7)], [6, 6, 6, 6]);
});

test("a level's patches are marked where they lie whole below a contact's node", () => {
  const ranges = patchRanges(NODES, PARENTS), into = new Uint8Array(4);
  markCovered(ranges, [4, 5, -1, 0], [{ node: 5, level: 1 }, { node: -1, level: 0 }, { node: 99, level: 0 }], into);
  assert.deepEqual([...into], [0, 2, 0, 0]);
  markCovered(ranges, [4, 5, -1, 0], [{ node: 6, level: 2 }, { node: 0, level: 0 }], into);
  assert.deepEqual([...into], [3, 3, 0, 1], "a coarser contact covers it, a finer one only itself");
});

test("neighbouring numbers have colours that can be told apart", () => {
  for (let k = 0; k < 200; k++) {
    const a = tint(k), b = tint(k + 1);
    assert.ok(Math.hypot(...a.map((value, i) => value - b[i])) > 40, `${k}: ${a} and ${b}`);
    assert.ok(a.every((value) => value >= 0 && value <= 255));
  }
});

test("every triangle stands once with its patch, those of none nowhere", () => {
  const labels = Float32Array.from([2, -1, 0, 2, 2, -1, 0]);
  const { begin, list } = trianglesByPatch(labels, 4);
  assert.deepEqual([0, 1, 2, 3].map((patch) => [...list.slice(begin[patch], begin[patch + 1])]), [[2, 6], [], [0, 3, 4], []]);
});

test("triangles of no patch have a label below 0", () => {
  const mesh = { triangles: new Uint32Array(9), patchOfTriangle: Uint32Array.from([3, NOTHING, 70000]) };
  assert.deepEqual([...patchLabels(mesh)], [3, -1, 70000]);
});
