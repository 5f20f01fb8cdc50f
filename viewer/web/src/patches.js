// Which patches lie below a node of the hierarchy: what a contact of that node colours.
import { NOTHING } from "./protocol.js";

/// nodeOfPatch, parents   as in the `mesh` message
/// returns                {order: patches so that those below any node stand together, begin, end: by node}
/// errors                 RangeError when the parents run in a circle
export function patchRanges(nodeOfPatch, parents) {
  const N = parents.length;
  const weight = new Uint32Array(N); // patches of the node itself
  for (const node of nodeOfPatch) weight[node]++;
  const sequence = parentsFirst(parents);
  const total = weight.slice();
  for (let k = N - 1; k >= 0; k--) {
    const node = sequence[k];
    if (parents[node] >= 0) total[parents[node]] += total[node];
  }
  const begin = new Uint32Array(N), end = new Uint32Array(N), free = new Uint32Array(N);
  let roots = 0;
  for (const node of sequence) {
    const parent = parents[node];
    begin[node] = parent < 0 ? roots : free[parent];
    end[node] = begin[node] + total[node];
    if (parent < 0) roots = end[node];
    else free[parent] = end[node];
    free[node] = begin[node] + weight[node]; // a node's own patches come first, then its children's
  }
  const order = new Uint32Array(nodeOfPatch.length);
  const next = begin.slice();
  for (let patch = 0; patch < nodeOfPatch.length; patch++) order[next[nodeOfPatch[patch]]++] = patch;
  return { order, begin, end };
}

function parentsFirst(parents) {
  const children = parents.map(() => 0);
  for (const parent of parents) if (parent >= 0) children[parent]++;
  const sequence = new Uint32Array(parents.length);
  let at = parents.length;
  const ready = [];
  for (let node = 0; node < parents.length; node++) if (children[node] === 0) ready.push(node);
  while (ready.length > 0) { // leaves last, so filled from the back
    const node = ready.pop();
    sequence[--at] = node;
    if (parents[node] >= 0 && --children[parents[node]] === 0) ready.push(parents[node]);
  }
  if (at !== 0) throw new RangeError("the hierarchy runs in a circle");
  return sequence;
}

/// Levels of the patches below the contacts' nodes: `into` gets level + 1 for each patch, 0 elsewhere. The finer level
/// stays where two meet.
/// active   [{node, level}]
export function markPatches(ranges, active, into) {
  into.fill(0);
  for (const { node, level } of active) {
    if (node < 0 || node >= ranges.begin.length) continue;
    for (let k = ranges.begin[node]; k < ranges.end[node]; k++) {
      const patch = ranges.order[k];
      if (into[patch] === 0 || into[patch] > level + 1) into[patch] = Math.min(255, level + 1);
    }
  }
}

/// Patch of a triangle for drawing: -1 for none.
const patchOf = (mesh, triangle) => (mesh.patchOfTriangle[triangle] === NOTHING ? -1 : mesh.patchOfTriangle[triangle]);

/// patchOf of all triangles, as numbers a vertex may carry.
export function patchLabels(mesh) {
  const labels = new Float32Array(mesh.triangles.length / 3);
  for (let t = 0; t < labels.length; t++) labels[t] = patchOf(mesh, t);
  return labels;
}

/// {begin, list}: the triangles of patch p are list[begin[p]] to before list[begin[p + 1]].
/// labels   patch of each triangle, below 0: of none
export function trianglesByPatch(labels, patches) {
  const begin = new Uint32Array(patches + 1);
  for (const patch of labels) if (patch >= 0) begin[patch + 1] += 1;
  for (let p = 0; p < patches; p++) begin[p + 1] += begin[p];
  const list = new Uint32Array(begin[patches]), next = begin.slice();
  labels.forEach((patch, t) => { if (patch >= 0) list[next[patch]++] = t; });
  return { begin, list };
}

/// Node a patch belongs to at a level: the coarsest above it that is not coarser than that.
export function groupsAtLevel(nodeOfPatch, parents, levels, level) {
  return Int32Array.from(nodeOfPatch, (leaf) => {
    let node = leaf;
    while (parents[node] >= 0 && levels[parents[node]] <= level) node = parents[node];
    return node;
  });
}

/// The same for the patches of a simplified level, drawn for contacts of any level: those that lie whole below a contact's node.
/// ranges   of the tree; nodeOfPatch names the nodes of the level's patches in it, -1 for none
export function markCovered(ranges, nodeOfPatch, active, into) {
  into.fill(0);
  const known = active.filter(({ node }) => node >= 0 && node < ranges.begin.length);
  for (let patch = 0; patch < nodeOfPatch.length; patch++) {
    const own = nodeOfPatch[patch];
    if (own < 0 || own >= ranges.begin.length) continue;
    for (const { node, level } of known) {
      const isBelow = ranges.begin[node] <= ranges.begin[own] && ranges.end[own] <= ranges.end[node];
      if (isBelow && (into[patch] === 0 || into[patch] > level + 1)) into[patch] = Math.min(255, level + 1);
    }
  }
}

/// A colour for a number that neighbours do not share: golden-angle hues, three lightnesses. [r, g, b] 0 to 255.
export function tint(number) {
  const hue = (number * 0.61803398875) % 1, light = [0.62, 0.5, 0.72][number % 3], strong = 0.55;
  const channel = (shift) => {
    const k = (shift + hue * 12) % 12;
    return Math.round(255 * (light - strong * Math.min(light, 1 - light) * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return [channel(0), channel(8), channel(4)];
}
