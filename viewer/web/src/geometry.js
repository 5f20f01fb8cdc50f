// Surfaces for drawing: corners split where the surface has an edge, so that teeth look round and gears sharp.

/// positions  3 numbers a vertex; triangles  3 indices a triangle
/// labels     a number a triangle; triangles of different labels share no vertex, so that a vertex can carry it
/// crease     faces that turn more than this against each other do not share a normal [rad]
/// normals    perhaps of the vertices, where those are known better than the triangles tell; zero, or where the surface has an
///            edge: not used
/// returns    {positions, normals, labels: Float32Array, index: Uint32Array}
export function splitAtCreases(positions, triangles, labels, { crease = 0.7, normals = null } = {}) {
  const { area, unit } = faceNormals(positions, triangles), { first, corners } = cornersByVertex(triangles, positions.length / 3);
  const out = { positions: new Float32Array(3 * triangles.length), normals: new Float32Array(3 * triangles.length),
    labels: new Float32Array(triangles.length) };
  const index = new Uint32Array(triangles.length), limit = Math.cos(crease);
  let made = 0;
  const masks = []; // of those made at the vertex: which faces share the normal
  for (let v = 0; v + 1 < first.length; v++) {
    const from = first[v], valence = first[v + 1] - from, madeBefore = made;
    const known = normals && Math.hypot(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]) > 0;
    for (let at = from; at < from + valence; at++) {
      const face = Math.floor(corners[at] / 3), own = 3 * face, label = labels[face];
      let x = 0, y = 0, z = 0, mask = 0, seen = 0;
      for (let k = 0; k < valence; k++) {
        const other = 3 * Math.floor(corners[from + k] / 3);
        const dot = unit[own] * unit[other] + unit[own + 1] * unit[other + 1] + unit[own + 2] * unit[other + 2];
        if (other !== own && !(dot > limit) && valence <= 31) continue; // a hub of more faces stays smooth
        mask |= 1 << (k & 31);
        seen += 1;
        x += area[other]; y += area[other + 1]; z += area[other + 2];
      }
      let like = madeBefore;
      while (like < made && !(masks[like - madeBefore] === mask && out.labels[like] === label)) like++;
      index[corners[at]] = like;
      if (like < made) continue;
      masks[made - madeBefore] = mask;
      out.labels[made] = label;
      if (known && seen === valence) { x = normals[3 * v]; y = normals[3 * v + 1]; z = normals[3 * v + 2]; }
      const length = Math.hypot(x, y, z) || 1;
      for (let k = 0; k < 3; k++) out.positions[3 * made + k] = positions[3 * v + k];
      out.normals[3 * made] = x / length;
      out.normals[3 * made + 1] = y / length;
      out.normals[3 * made + 2] = z / length;
      made += 1;
    }
  }
  return { positions: out.positions.slice(0, 3 * made), normals: out.normals.slice(0, 3 * made), labels: out.labels.slice(0, made), index };
}

/// {first, corners}: those of vertex v are corners[first[v]] to before corners[first[v + 1]].
function cornersByVertex(triangles, vertices) {
  const first = new Uint32Array(vertices + 1), corners = new Uint32Array(triangles.length);
  for (const v of triangles) first[v + 1]++;
  for (let v = 0; v < vertices; v++) first[v + 1] += first[v];
  const next = first.slice();
  for (let c = 0; c < triangles.length; c++) corners[next[triangles[c]]++] = c;
  return { first, corners };
}

/// {area: normals as long as twice the area, unit}
function faceNormals(positions, triangles) {
  const area = new Float64Array(triangles.length), unit = new Float64Array(triangles.length);
  for (let f = 0; f < triangles.length; f += 3) {
    const a = 3 * triangles[f], b = 3 * triangles[f + 1], c = 3 * triangles[f + 2];
    const ux = positions[b] - positions[a], uy = positions[b + 1] - positions[a + 1], uz = positions[b + 2] - positions[a + 2];
    const vx = positions[c] - positions[a], vy = positions[c + 1] - positions[a + 1], vz = positions[c + 2] - positions[a + 2];
    area[f] = uy * vz - uz * vy;
    area[f + 1] = uz * vx - ux * vz;
    area[f + 2] = ux * vy - uy * vx;
    const length = Math.hypot(area[f], area[f + 1], area[f + 2]);
    for (let k = f; k < f + 3; k++) unit[k] = length > 0 ? area[k] / length : 0;
  }
  return { area, unit };
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
