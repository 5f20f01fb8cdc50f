// Coarser surfaces of a mesh that has no levels of its own, for drawing alone: vertices are taken away one by one, flattest
// first, while each that was taken away lies within a distance of the surface that is left.

const TURN = 0.5; // cosine of how far a triangle may turn at a step: it never folds over
const EDGE = Math.cos(0.5); // of the turn from the mean normal beyond which the mesh has an edge
const SHORT = 1e-3; // where nothing is lost the shortest edge goes first: share of its length that counts as loss
const ENOUGH = 0.01; // a pass that takes fewer of the vertices is the last of its tolerance

/// mesh         {positions, triangles, patchOfTriangle}: 3 numbers a vertex, 3 indices a triangle, its patch
/// tolerances   ascending: how far a vertex of the mesh may be off the surface, in the unit of the positions
/// give         ({positions, normals, triangles, patchOfTriangle}, tolerance): called for each; triangles keep their patches,
///              vertices the normals that they have in the mesh, 0 where it has an edge
export function coarsen(mesh, tolerances, give) {
  const work = makeWork(mesh);
  for (const tolerance of tolerances) {
    for (;;) {
      const before = work.left;
      pass(work, tolerance);
      if (before - work.left <= ENOUGH * before) break;
    }
    give(result(work), tolerance);
  }
}

function makeWork({ positions, triangles, patchOfTriangle }) {
  const vertices = positions.length / 3;
  const work = { positions, normals: smoothNormals(positions, triangles), corners: Uint32Array.from(triangles), patches: Uint32Array.from(patchOfTriangle), left: vertices,
    losses: new Float64Array(11 * vertices), // of each vertex: squared distance from the planes around it, and their area
    first: new Int32Array(triangles.length / 3).fill(-1), // of each triangle a vertex that was taken away there, -1: none
    next: new Int32Array(vertices).fill(-1), // the next one of the same triangle
    touched: new Uint8Array(vertices), seen: new Uint32Array(vertices), stamp: 0, fan: [], moved: [], point: new Float64Array(3) };
  for (let t = 0; t < triangles.length; t += 3) addPlane(work, t);
  return work;
}

/// Mean normals of the triangles around each vertex, by area; 0 where one of them is turned by more than EDGE from that.
function smoothNormals(positions, triangles) {
  const normals = new Float32Array(positions.length), areas = [];
  const each = (act) => { for (let c = 0; c < triangles.length; c++) act(3 * triangles[c], areas[Math.floor(c / 3)]); };
  for (let t = 0; t < triangles.length; t += 3) areas.push(cross(positions, 3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]));
  each((v, n) => { for (let k = 0; k < 3; k++) normals[v + k] += n[k]; });
  for (let v = 0; v < normals.length; v += 3) {
    const length = Math.hypot(normals[v], normals[v + 1], normals[v + 2]) || 1;
    for (let k = 0; k < 3; k++) normals[v + k] /= length;
  }
  const isEdge = new Uint8Array(positions.length / 3);
  each((v, n) => {
    const along = n[0] * normals[v] + n[1] * normals[v + 1] + n[2] * normals[v + 2];
    if (along < EDGE * Math.hypot(...n)) isEdge[v / 3] = 1;
  });
  return normals.map((value, at) => (isEdge[Math.floor(at / 3)] ? 0 : value));
}

/// Of the plane of a triangle to its corners, by area.
function addPlane({ positions, corners, losses }, t) {
  const [a, b, c] = [3 * corners[t], 3 * corners[t + 1], 3 * corners[t + 2]];
  const n = cross(positions, a, b, c), area = Math.hypot(...n);
  if (!(area > 0)) return;
  const [x, y, z] = n.map((one) => one / area), d = -(x * positions[a] + y * positions[a + 1] + z * positions[a + 2]);
  const terms = [x * x, x * y, x * z, x * d, y * y, y * z, y * d, z * z, z * d, d * d, 1];
  for (const v of [a, b, c]) for (let k = 0; k < 11; k++) losses[(11 * v) / 3 + k] += area * terms[k];
}

/// Twice the area of a triangle of three points, along its normal.
function cross(p, a, b, c) {
  const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
  const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
  return [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
}

/// What is lost where v goes to where u is: the mean squared distance from the planes of both.
function lossOf({ losses: q, positions: p }, v, u) {
  const i = 11 * v, j = 11 * u, [x, y, z] = [p[3 * u], p[3 * u + 1], p[3 * u + 2]];
  const term = (k) => q[i + k] + q[j + k];
  const sum = term(0) * x * x + term(4) * y * y + term(7) * z * z + term(9)
    + 2 * (term(1) * x * y + term(2) * x * z + term(3) * x + term(5) * y * z + term(6) * y + term(8) * z);
  return Math.max(0, sum / (term(10) || 1));
}

const squareLength = ({ positions: p }, v, u) => (p[3 * v] - p[3 * u]) ** 2 + (p[3 * v + 1] - p[3 * u + 1]) ** 2 + (p[3 * v + 2] - p[3 * u + 2]) ** 2;

/// Each edge that loses little enough is closed, those that lose least first, where nothing around has changed in this pass.
function pass(work, tolerance) {
  const { corners } = work, around = trianglesAround(work);
  const from = [], to = [], cost = [];
  for (let c = 0; c < corners.length; c++) {
    const v = corners[c], u = corners[c % 3 === 2 ? c - 2 : c + 1];
    const loss = lossOf(work, v, u), back = lossOf(work, u, v);
    if (loss > tolerance * tolerance || loss > back || (loss === back && v > u)) continue;
    from.push(v); to.push(u); cost.push(loss + SHORT * squareLength(work, v, u));
  }
  const order = Uint32Array.from(from, (_, k) => k).sort((a, b) => cost[a] - cost[b] || a - b);
  work.touched.fill(0);
  for (const k of order) close(work, around, from[k], to[k], tolerance);
  compact(work);
}

/// {begin, list}: the triangles of vertex v are list[begin[v]] to before list[begin[v + 1]].
function trianglesAround({ corners, next }) {
  const begin = new Uint32Array(next.length + 1), list = new Uint32Array(corners.length);
  for (const v of corners) begin[v + 1]++;
  for (let v = 0; v < next.length; v++) begin[v + 1] += begin[v];
  const free = begin.slice();
  for (let c = 0; c < corners.length; c++) list[free[corners[c]]++] = Math.floor(c / 3);
  return { begin, list };
}

/// Takes v away: its triangles get u in its place, where that is allowed.
function close(work, around, v, u, tolerance) {
  if (work.touched[v] || work.touched[u] || !isSimple(work, around, v, u)) return;
  const { corners, fan, moved, first, next } = work;
  fan.length = moved.length = 0;
  moved.push(v);
  for (let k = around.begin[v]; k < around.begin[v + 1]; k++) {
    const t = around.list[k], [a, b, c] = [corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]];
    if (work.touched[a] || work.touched[b] || work.touched[c]) return;
    for (let one = first[t]; one >= 0; one = next[one]) moved.push(one);
    if (a === u || b === u || c === u) continue;
    const now = a === v ? [u, b, c] : b === v ? [a, u, c] : [a, b, u];
    if (turns(work.positions, [a, b, c], now)) return;
    fan.push(t, ...now);
  }
  if (!isNear(work, around, v, tolerance * tolerance)) return;
  const homes = moved.map((one) => homeOf(work, one, tolerance * tolerance));
  if (homes.includes(-1)) return;
  settle(work, around, v, u, homes);
}

/// Whether the triangles around v close a disc, and v and u have only the two neighbours of their edge in common.
function isSimple(work, { begin, list }, v, u) {
  const { corners, seen } = work, base = (work.stamp += 4); // seen - base: how often around v
  let shared = 0;
  for (let k = begin[v]; k < begin[v + 1]; k++) {
    for (let c = 3 * list[k]; c < 3 * list[k] + 3; c++) {
      const w = corners[c];
      if (w === v) continue;
      seen[w] = seen[w] >= base ? seen[w] + 1 : base + 1;
      if (seen[w] > base + 2) return false;
    }
  }
  for (let k = begin[v]; k < begin[v + 1]; k++) {
    for (let c = 3 * list[k]; c < 3 * list[k] + 3; c++) if (corners[c] !== v && seen[corners[c]] !== base + 2) return false;
  }
  seen[u] = base; // not its own neighbour
  for (let k = begin[u]; k < begin[u + 1]; k++) {
    for (let c = 3 * list[k]; c < 3 * list[k] + 3; c++) {
      const w = corners[c];
      if (seen[w] !== base + 2) continue;
      seen[w] = base; // counted
      shared += 1;
    }
  }
  return shared === 2;
}

function turns(positions, before, now) {
  const m = cross(positions, ...before.map((v) => 3 * v)), n = cross(positions, ...now.map((v) => 3 * v));
  return !(m[0] * n[0] + m[1] * n[1] + m[2] * n[2] > TURN * Math.hypot(...m) * Math.hypot(...n));
}

/// Whether the middles of the fan's triangles and of its edges at u lie near the triangles around v as they are: where u is near
/// and all that was taken away as well, what spans a hollow is not.
function isNear({ positions: p, corners, fan, point }, { begin, list }, v, most) {
  for (let k = 0; k < fan.length; k += 4) {
    const at = (one, axis) => p[3 * fan[k + 1 + one] + axis];
    for (let which = 0; which < 4; which++) {
      for (let axis = 0; axis < 3; axis++) {
        const [a, b, c] = [at(0, axis), at(1, axis), at(2, axis)];
        point[axis] = which === 3 ? (a + b + c) / 3 : 0.5 * (which === 0 ? a + b : which === 1 ? b + c : c + a);
      }
      let isHere = false;
      for (let t = begin[v]; t < begin[v + 1] && !isHere; t++) {
        const c = 3 * list[t];
        isHere = squareDistance(point, p, 3 * corners[c], 3 * corners[c + 1], 3 * corners[c + 2]) <= most;
      }
      if (!isHere) return false;
    }
  }
  return true;
}

/// The triangle of the fan that is nearest to a vertex, as its place in it; -1 where none is near enough.
function homeOf({ positions, fan, point }, vertex, most) {
  let best = -1;
  for (let axis = 0; axis < 3; axis++) point[axis] = positions[3 * vertex + axis];
  for (let k = 0; k < fan.length; k += 4) {
    const square = squareDistance(point, positions, 3 * fan[k + 1], 3 * fan[k + 2], 3 * fan[k + 3]);
    if (square > most) continue;
    most = square;
    best = k;
  }
  return best;
}

function settle(work, { begin, list }, v, u, homes) {
  const { corners, touched, first, next, fan, moved, losses } = work;
  for (let k = begin[v]; k < begin[v + 1]; k++) {
    const t = list[k];
    for (let c = 3 * t; c < 3 * t + 3; c++) touched[corners[c]] = 1;
    first[t] = -1;
    corners.fill(u, 3 * t, 3 * t + 3); // none, unless it is of the fan
  }
  for (let k = 0; k < fan.length; k += 4) corners.set([fan[k + 1], fan[k + 2], fan[k + 3]], 3 * fan[k]);
  moved.forEach((one, k) => {
    const t = fan[homes[k]];
    next[one] = first[t];
    first[t] = one;
  });
  for (let k = 0; k < 11; k++) losses[11 * u + k] += losses[11 * v + k];
  work.left -= 1;
}

/// Leaves out the triangles that are none any more.
function compact(work) {
  let kept = 0;
  const { corners, patches, first } = work;
  for (let t = 0; t < patches.length; t++) {
    if (corners[3 * t] === corners[3 * t + 1]) continue;
    corners.copyWithin(3 * kept, 3 * t, 3 * t + 3);
    patches[kept] = patches[t];
    first[kept] = first[t];
    kept += 1;
  }
  Object.assign(work, { corners: corners.slice(0, 3 * kept), patches: patches.slice(0, kept), first: first.slice(0, kept) });
}

function result({ positions, normals, corners, patches }) {
  const number = new Int32Array(positions.length / 3).fill(-1), kept = [];
  const triangles = corners.map((v) => {
    if (number[v] < 0) number[v] = kept.push(v) - 1;
    return number[v];
  });
  const pick = (values) => {
    const picked = new Float32Array(3 * kept.length);
    for (let at = 0; at < picked.length; at++) picked[at] = values[3 * kept[Math.floor(at / 3)] + (at % 3)];
    return picked;
  };
  return { positions: pick(positions), normals: pick(normals), triangles, patchOfTriangle: patches.slice() };
}

/// Squared distance of a point from a triangle.
/// point   its coordinates; a, b, c   where those of the corners begin in x
export function squareDistance(point, x, a, b, c) {
  const edge = (from, to) => [x[to] - x[from], x[to + 1] - x[from + 1], x[to + 2] - x[from + 2]];
  const off = (at) => [point[0] - x[at], point[1] - x[at + 1], point[2] - x[at + 2]];
  const ab = edge(a, b), ac = edge(a, c), ap = off(a), bp = off(b), cp = off(c);
  const dot = (m, n) => m[0] * n[0] + m[1] * n[1] + m[2] * n[2];
  const d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp), d6 = dot(ac, cp);
  const from = (q, s, m, r, n) => (q[0] - s * m[0] - r * n[0]) ** 2 + (q[1] - s * m[1] - r * n[1]) ** 2 + (q[2] - s * m[2] - r * n[2]) ** 2;
  if (d1 <= 0 && d2 <= 0) return dot(ap, ap);
  if (d3 >= 0 && d4 <= d3) return dot(bp, bp);
  if (d6 >= 0 && d5 <= d6) return dot(cp, cp);
  const vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return from(ap, d1 / (d1 - d3), ab, 0, ac);
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return from(ap, 0, ab, d2 / (d2 - d6), ac);
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const w = (d4 - d3) / (d4 - d3 + (d5 - d6));
    return from(ap, 1 - w, ab, w, ac);
  }
  const sum = va + vb + vc;
  return from(ap, vb / sum, ab, vc / sum, ac);
}
