// A coarser surface of a mesh that has no levels of its own, for drawing alone: vertices of one cell of a grid become one.

/// mesh     {positions, triangles, patchOfTriangle, ...}; cell   side of the grid's cells, in the unit of the positions
/// returns  {mesh: the same with fewer triangles, which keep their patches; deviation: how far a vertex has moved at the most,
///          and so any point of the surface}
export function clusterMesh(mesh, cell) {
  const { positions, triangles, patchOfTriangle } = mesh, vertices = positions.length / 3;
  const clusterOf = new Uint32Array(vertices), numbers = new Map();
  const at = (v, k) => Math.floor(positions[3 * v + k] / cell) + 1e5; // cells are counted from far outside
  for (let v = 0; v < vertices; v++) {
    const key = (at(v, 0) * 2e5 + at(v, 1)) * 2e5 + at(v, 2);
    let number = numbers.get(key);
    if (number === undefined) numbers.set(key, number = numbers.size);
    clusterOf[v] = number;
  }
  const means = new Float32Array(3 * numbers.size), counts = new Uint32Array(numbers.size);
  const sums = new Float64Array(3 * numbers.size);
  for (let v = 0; v < vertices; v++) {
    counts[clusterOf[v]] += 1;
    for (let k = 0; k < 3; k++) sums[3 * clusterOf[v] + k] += positions[3 * v + k];
  }
  for (let c = 0; c < means.length; c++) means[c] = sums[c] / counts[Math.floor(c / 3)];
  let farthest = 0;
  for (let v = 0; v < vertices; v++) {
    let across = 0;
    for (let k = 0; k < 3; k++) across += (positions[3 * v + k] - means[3 * clusterOf[v] + k]) ** 2;
    farthest = Math.max(farthest, across);
  }
  const kept = [], patches = [];
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [clusterOf[triangles[t]], clusterOf[triangles[t + 1]], clusterOf[triangles[t + 2]]];
    if (a === b || b === c || c === a) continue;
    kept.push(a, b, c);
    patches.push(patchOfTriangle[t / 3]);
  }
  return { mesh: { ...mesh, positions: means, triangles: Uint32Array.from(kept), patchOfTriangle: Uint32Array.from(patches) },
    deviation: Math.sqrt(farthest) };
}

const CELLS = [0.064, 0.032, 0.016, 0.008]; // of the object's radius, coarsest first
const LIKELY = 0.6; // of a cell is what vertices move: worth making
const FEWEST = 4000; // triangles; fewer are drawn as they are

/// Which made surface an object without levels is drawn by: 0 the original, below it the cells of CELLS.
/// made      Map of those that are there, by number; triangles   of the original; radius of the object
/// allowed   how far it may be off [m]
/// make      (number, cell) -> its deviation [m], once it is there
export function madeLevel(made, triangles, radius, allowed, make) {
  if (triangles < FEWEST) return 0;
  for (let k = 0; k < CELLS.length; k++) {
    const number = -1 - k, cell = CELLS[k] * radius;
    if (!made.has(number) && LIKELY * cell > allowed) continue;
    const deviation = made.get(number) ?? make(number, cell);
    if (deviation <= allowed) return number;
  }
  return 0;
}
