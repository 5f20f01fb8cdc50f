import assert from "node:assert/strict";
import { test } from "node:test";
import { clusterMesh, madeLevel } from "../../src/cluster.js";
import { makeBlock } from "../mock/world.mjs";

const block = () => { const mesh = makeBlock(true);
  return { ...mesh, positions: Float32Array.from(mesh.positions), triangles: Uint32Array.from(mesh.triangles), patchOfTriangle: Uint32Array.from(mesh.patchOfTriangle) }; };

test("a coarser surface has fewer triangles, of the same patches, none degenerate, and says how far it is off", () => {
  const fine = block();
  let before = fine.triangles.length;
  for (const cell of [0.002, 0.004, 0.008]) {
    const { mesh, deviation } = clusterMesh(fine, cell);
    assert.ok(mesh.triangles.length < before, "fewer and fewer");
    before = mesh.triangles.length;
    assert.equal(mesh.patchOfTriangle.length, mesh.triangles.length / 3);
    for (let t = 0; t < mesh.triangles.length; t += 3) {
      const corners = [...mesh.triangles.slice(t, t + 3)];
      assert.equal(new Set(corners).size, 3);
      assert.ok(corners.every((v) => v < mesh.positions.length / 3));
    }
    // Against every vertex: none is farther from the nearest of the coarse ones than said.
    let farthest = 0;
    for (let v = 0; v < fine.positions.length; v += 3) {
      let nearest = Infinity;
      for (let c = 0; c < mesh.positions.length; c += 3) {
        nearest = Math.min(nearest, Math.hypot(...[0, 1, 2].map((k) => fine.positions[v + k] - mesh.positions[c + k])));
      }
      farthest = Math.max(farthest, nearest);
    }
    assert.ok(farthest <= deviation * (1 + 1e-5) && deviation <= Math.sqrt(3) * cell, `${farthest}, ${deviation} of cells of ${cell}`);
  }
});

test("a cell as small as nothing keeps everything, at any scale", () => {
  const fine = block();
  for (const scale of [1, 1e-6]) {
    const positions = fine.positions.map((x) => x * scale);
    const { mesh, deviation } = clusterMesh({ ...fine, positions }, 1e-5 * scale);
    assert.equal(mesh.triangles.length, fine.triangles.length);
    assert.equal(deviation, 0);
  }
});

test("the coarsest that is fine enough is drawn, and made once", () => {
  const made = new Map(), tries = [];
  const make = (number, cell) => { tries.push(number); made.set(number, 0.7 * cell); return 0.7 * cell; };
  const level = (allowed) => madeLevel(made, 50000, 1, allowed, make);
  assert.equal(level(0.001), 0);
  assert.deepEqual(tries, [], "what cannot be fine enough is not made");
  assert.equal(level(0.012), -3);
  assert.equal(level(0.012), -3);
  assert.deepEqual(tries, [-3]);
  assert.equal(level(0.041), -2, "-1 was made, and is too coarse");
  assert.deepEqual(tries, [-3, -1, -2]);
  assert.equal(madeLevel(made, 1000, 1, 1, make), 0, "few triangles need none");
});
