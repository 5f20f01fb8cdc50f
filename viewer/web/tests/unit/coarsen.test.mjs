import assert from "node:assert/strict";
import { test } from "node:test";
import { coarsen, squareDistance } from "../../src/coarsen.js";
import { makeBlock } from "../mock/world.mjs";

const arrays = (mesh) => ({ positions: Float32Array.from(mesh.positions), triangles: Uint32Array.from(mesh.triangles),
  patchOfTriangle: Uint32Array.from(mesh.patchOfTriangle) });
const all = (mesh, tolerances) => { const list = []; coarsen(mesh, tolerances, (surface, tolerance) => list.push({ ...surface, tolerance })); return list; };
const corners = ({ triangles }, t) => [3 * triangles[3 * t], 3 * triangles[3 * t + 1], 3 * triangles[3 * t + 2]];

/// Of a point from the nearest of all triangles.
function distance(point, mesh) {
  let least = Infinity;
  for (let t = 0; t < mesh.triangles.length / 3; t++) least = Math.min(least, squareDistance(point, mesh.positions, ...corners(mesh, t)));
  return Math.sqrt(least);
}

test("a point is as far from a triangle as from the nearest of many of its points", () => {
  let seed = 7;
  const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
  for (let trial = 0; trial < 200; trial++) {
    const x = Float64Array.from({ length: 12 }, () => random() - 0.5), N = 60;
    let least = Infinity;
    for (let i = 0; i <= N; i++) for (let j = 0; i + j <= N; j++) {
      const [u, v] = [i / N, j / N];
      least = Math.min(least, Math.hypot(...[0, 1, 2].map((k) => x[k] - (1 - u - v) * x[3 + k] - u * x[6 + k] - v * x[9 + k])));
    }
    const said = Math.sqrt(squareDistance(x, x, 3, 6, 9));
    assert.ok(said <= least + 1e-12 && least - said < 0.03, `${said} and ${least}`);
  }
});

test("coarser and coarser surfaces are closed, of the same patches, and as near to the original as they say, both ways", () => {
  const fine = arrays(makeBlock(true));
  let before = fine.triangles.length;
  for (const coarse of all(fine, [2e-5, 1e-4, 5e-4])) {
    const { positions, normals, triangles, patchOfTriangle, tolerance } = coarse;
    assert.ok(triangles.length < 0.9 * before, `${triangles.length / 3} triangles of ${before / 3}`);
    before = triangles.length;
    assert.equal(patchOfTriangle.length, triangles.length / 3);
    assert.equal(normals.length, positions.length);
    assert.ok(patchOfTriangle.every((patch) => fine.patchOfTriangle.includes(patch)));
    const edges = new Set();
    for (let c = 0; c < triangles.length; c++) {
      const edge = `${triangles[c]} ${triangles[c % 3 === 2 ? c - 2 : c + 1]}`;
      assert.ok(!edges.has(edge), "no two triangles on one side of an edge");
      edges.add(edge);
    }
    for (const edge of edges) assert.ok(edges.has(edge.split(" ").reverse().join(" ")), "each has its other side");
    let there = 0, back = 0;
    for (let v = 0; v < fine.positions.length; v += 21) there = Math.max(there, distance(fine.positions.subarray(v, v + 3), coarse));
    for (let t = 0; t < triangles.length / 3; t += 11) { // the middles of triangles and of edges
      const points = corners(coarse, t).map((at) => [...positions.subarray(at, at + 3)]);
      const mix = (shares) => [0, 1, 2].map((k) => shares.reduce((sum, share, one) => sum + share * points[one][k], 0));
      for (const shares of [[1 / 3, 1 / 3, 1 / 3], [0.5, 0.5, 0], [0, 0.5, 0.5], [0.5, 0, 0.5]]) back = Math.max(back, distance(mix(shares), fine));
    }
    assert.ok(there <= tolerance * (1 + 1e-5), `${there} of ${tolerance}`);
    assert.ok(back <= 1.5 * tolerance, `back ${back} of ${tolerance}`);
  }
});

test("the unit of length does not matter", () => {
  const fine = arrays(makeBlock(true));
  const [one] = all(fine, [1e-4]), [other] = all({ ...fine, positions: fine.positions.map((x) => x * 2 ** -20) }, [1e-4 * 2 ** -20]);
  assert.deepEqual(other.triangles, one.triangles);
  assert.deepEqual(other.normals, one.normals);
});

test("vertices keep their normals, and none at edges", () => {
  const [{ positions, normals }] = all(arrays(makeBlock(true)), [1e-4]);
  let smooth = 0, edges = 0;
  for (let v = 0; v < positions.length; v += 3) {
    const length = Math.hypot(...normals.subarray(v, v + 3)), isRim = [0, 1].some((k) => Math.abs(Math.abs(positions[v + k]) - 0.03) < 1e-6);
    if (isRim) { assert.equal(length, 0); edges += 1; continue; }
    assert.ok(length === 0 || Math.abs(length - 1) < 1e-5);
    smooth += length > 0 ? 1 : 0;
  }
  assert.ok(smooth > 20 && edges >= 8);
});

test("the rim of an open surface stays, and what is no surface is left as it is", () => {
  const positions = [], triangles = [], N = 12;
  for (let j = 0; j <= N; j++) for (let i = 0; i <= N; i++) positions.push(i, j, 0);
  for (let j = 0; j < N; j++) for (let i = 0; i < N; i++) {
    const a = j * (N + 1) + i;
    triangles.push(a, a + 1, a + N + 2, a, a + N + 2, a + N + 1);
  }
  const sheet = arrays({ positions, triangles, patchOfTriangle: Array(2 * N * N).fill(0) });
  const [flat] = all(sheet, [0.1]);
  const area = (mesh) => { let sum = 0; for (let t = 0; t < mesh.triangles.length / 3; t++) { const [a, b, c] = corners(mesh, t), p = mesh.positions;
    sum += 0.5 * ((p[b] - p[a]) * (p[c + 1] - p[a + 1]) - (p[b + 1] - p[a + 1]) * (p[c] - p[a])); } return sum; };
  assert.ok(Math.abs(area(flat) - N * N) < 1e-6 * N * N, "nothing of it folds over or is missing");
  assert.ok(flat.triangles.length < sheet.triangles.length / 3);
  for (let k = 0; k <= N; k++) assert.ok([...flat.positions.keys()].some((v) => v % 3 === 0 && flat.positions[v] === k && flat.positions[v + 1] === 0));
  // Three triangles at an edge, one without area, one twice.
  const broken = arrays({ positions: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0], triangles: [0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 0, 1, 0, 1, 2],
    patchOfTriangle: [0, 0, 0, 0, 0] });
  assert.ok(all(broken, [0.1, 10]).every((one) => one.triangles.length >= 9));
  assert.ok(all({ ...broken, positions: broken.positions.map(() => NaN) }, [0.1]).length === 1);
  assert.equal(all(arrays({ positions: [], triangles: [], patchOfTriangle: [] }), [0.1])[0].triangles.length, 0);
});
