// Surfaces for drawing: corners split where the surface has an edge, so that teeth look round and gears sharp.

/// positions  3 numbers a vertex; triangles  3 indices a triangle
/// labels     a number a triangle; triangles of different labels share no vertex, so that a vertex can carry it
/// crease     faces that turn more than this against each other do not share a normal [rad]
/// normals    perhaps of the vertices, where those are known better than the triangles tell; zero, or where the surface has an
///            edge: not used
/// returns    {positions, normals, labels: Float32Array, index: Uint32Array}
export function splitAtCreases(positions, triangles, labels, { crease = 0.7, normals = null } = {}) {
  const faces = triangles.length / 3;
  const vertices = positions.length / 3;
  const area = new Float64Array(triangles.length); // normals as long as twice the area
  const unit = new Float64Array(triangles.length);
  for (let f = 0; f < faces; f++) faceNormal(positions, triangles, f, area, unit);

  const first = new Uint32Array(vertices + 1); // corners by vertex
  for (const v of triangles) first[v + 1]++;
  for (let v = 0; v < vertices; v++) first[v + 1] += first[v];
  const corners = new Uint32Array(triangles.length);
  const next = first.slice();
  for (let c = 0; c < triangles.length; c++) corners[next[triangles[c]]++] = c;

  const outPositions = [], outNormals = [], outLabels = [];
  const index = new Uint32Array(triangles.length);
  const limit = Math.cos(crease);
  for (let v = 0; v < vertices; v++) {
    const around = corners.subarray(first[v], first[v + 1]);
    const known = normals && Math.hypot(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]) > 0;
    const made = new Map(); // which faces share a normal, and the label -> new vertex
    for (const corner of around) {
      const own = 3 * Math.floor(corner / 3);
      let x = 0, y = 0, z = 0, mask = 0, seen = 0;
      for (let k = 0; k < around.length; k++) {
        const other = 3 * Math.floor(around[k] / 3);
        const dot = unit[own] * unit[other] + unit[own + 1] * unit[other + 1] + unit[own + 2] * unit[other + 2];
        if (other !== own && !(dot > limit) && around.length <= 31) continue; // a hub of more faces stays smooth
        mask |= 1 << (k & 31);
        seen += 1;
        x += area[other]; y += area[other + 1]; z += area[other + 2];
      }
      const label = labels[Math.floor(corner / 3)];
      const key = label * 2 ** 32 + (mask >>> 0);
      if (!made.has(key)) {
        made.set(key, outPositions.length / 3);
        outLabels.push(label);
        outPositions.push(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]);
        if (known && seen === around.length) [x, y, z] = normals.subarray(3 * v, 3 * v + 3);
        const length = Math.hypot(x, y, z) || 1;
        outNormals.push(x / length, y / length, z / length);
      }
      index[corner] = made.get(key);
    }
  }
  return { positions: Float32Array.from(outPositions), normals: Float32Array.from(outNormals),
    labels: Float32Array.from(outLabels), index };
}

function faceNormal(positions, triangles, f, area, unit) {
  const a = 3 * triangles[3 * f], b = 3 * triangles[3 * f + 1], c = 3 * triangles[3 * f + 2];
  const ux = positions[b] - positions[a], uy = positions[b + 1] - positions[a + 1], uz = positions[b + 2] - positions[a + 2];
  const vx = positions[c] - positions[a], vy = positions[c + 1] - positions[a + 1], vz = positions[c + 2] - positions[a + 2];
  const n = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(n[0], n[1], n[2]);
  for (let k = 0; k < 3; k++) {
    area[3 * f + k] = n[k];
    unit[3 * f + k] = length > 0 ? n[k] / length : 0;
  }
}

/// Every edge once: pairs of vertex indices.
export function uniqueEdges(triangles) {
  const keys = new Float64Array(triangles.length);
  const span = triangles.reduce((most, v) => Math.max(most, v), 0) + 1;
  for (let c = 0; c < triangles.length; c++) {
    const a = triangles[c], b = triangles[c % 3 === 2 ? c - 2 : c + 1];
    keys[c] = Math.min(a, b) * span + Math.max(a, b);
  }
  keys.sort();
  const edges = [];
  for (let k = 0; k < keys.length; k++) {
    if (k > 0 && keys[k] === keys[k - 1]) continue;
    edges.push(Math.floor(keys[k] / span), keys[k] % span);
  }
  return Uint32Array.from(edges);
}

/// The longest length of 1, 2 or 5 times a power of ten that is not above `most`.
export function roundLength(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  return power * [5, 2, 1].find((digit) => digit * power <= most * (1 + 1e-9));
}

/// Box around points: {min, max, center, radius}; radius is half its diagonal.
export function boundsOf(positions) {
  const min = [Infinity, Infinity, Infinity], max = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    const k = i % 3;
    if (positions[i] < min[k]) min[k] = positions[i];
    if (positions[i] > max[k]) max[k] = positions[i];
  }
  const center = min.map((low, k) => 0.5 * (low + max[k]));
  return { min, max, center, radius: 0.5 * Math.hypot(...min.map((low, k) => max[k] - low)) };
}
