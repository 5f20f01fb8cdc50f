import assert from "node:assert/strict";
import { test } from "node:test";
import { boundsOf, splitAtCreases, uniqueEdges } from "../../src/geometry.js";

const CUBE = { positions: [], triangles: [] };
for (let k = 0; k < 8; k++) CUBE.positions.push(k & 1, (k >> 1) & 1, (k >> 2) & 1);
for (const [a, b, c, d] of [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]) {
  CUBE.triangles.push(a, b, c, a, c, d);
}

test("a cube gets a normal for each of its faces", () => {
  const split = splitAtCreases(CUBE.positions, CUBE.triangles, new Float32Array(12));
  assert.equal(split.positions.length / 3, 24);
  for (let t = 0; t < 12; t++) {
    const [a, b, c] = [0, 1, 2].map((k) => [...split.normals.slice(3 * split.index[3 * t + k], 3 * split.index[3 * t + k] + 3)]);
    assert.deepEqual([a, b], [c, c]);
    assert.equal(a.map(Math.abs).reduce((sum, x) => sum + x), 1);
  }
});

test("below the crease angle the cube is smooth", () => {
  assert.equal(splitAtCreases(CUBE.positions, CUBE.triangles, new Float32Array(12), { crease: 2 }).positions.length / 3, 8);
});

test("triangles of different labels share no vertex", () => {
  const labels = Float32Array.from({ length: 12 }, (_, t) => t % 3 - 1);
  const split = splitAtCreases(CUBE.positions, CUBE.triangles, labels, { crease: 2 });
  for (let c = 0; c < 36; c++) {
    assert.equal(split.labels[split.index[c]], labels[Math.floor(c / 3)]);
    for (let k = 0; k < 3; k++) assert.equal(split.positions[3 * split.index[c] + k], CUBE.positions[3 * CUBE.triangles[c] + k]);
  }
});

test("normals that are known are used where the surface is smooth, and nowhere else", () => {
  const normals = new Float32Array(CUBE.positions.length).fill(0).map((_, k) => (k < 3 ? Number(k === 0) : 0)); // of the first vertex
  const normalOf = (split, v) => [0, 1, 2].map((k) => [...split.index.keys()].filter((c) => CUBE.triangles[c] === v).map((c) => split.normals[3 * split.index[c] + k]));
  const smooth = splitAtCreases(CUBE.positions, CUBE.triangles, new Float32Array(12), { crease: 2, normals });
  assert.deepEqual(normalOf(smooth, 0).map((list) => new Set(list)), [new Set([1]), new Set([0]), new Set([0])]);
  const plain = splitAtCreases(CUBE.positions, CUBE.triangles, new Float32Array(12), { crease: 2 });
  assert.deepEqual(normalOf(smooth, 5), normalOf(plain, 5));
  assert.deepEqual(splitAtCreases(CUBE.positions, CUBE.triangles, new Float32Array(12), { normals }), splitAtCreases(CUBE.positions, CUBE.triangles, new Float32Array(12)));
});

test("the scale does not matter", () => {
  for (const scale of [1e-9, 1e3]) {
    const split = splitAtCreases(CUBE.positions.map((x) => x * scale), CUBE.triangles, new Float32Array(12));
    assert.equal(split.positions.length / 3, 24);
  }
});

test("edges come once", () => {
  const edges = uniqueEdges(Uint32Array.from(CUBE.triangles));
  assert.equal(edges.length / 2, 18); // 12 of the cube, 6 diagonals
  assert.equal(new Set(Array.from({ length: 18 }, (_, k) => `${edges[2 * k]} ${edges[2 * k + 1]}`)).size, 18);
});

test("bounds", () => {
  const box = boundsOf([0, 0, 0, 2, 4, 4]);
  assert.deepEqual([box.center, box.radius], [[1, 2, 2], 3]);
});
