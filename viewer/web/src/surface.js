// One surface as drawn: coloured near the contacts by their level of detail, its triangles perhaps as lines.
import { BufferAttribute, BufferGeometry, Color, DataTexture, DynamicDrawUsage, Group, LineBasicMaterial, LineSegments, Mesh, RedFormat,
  RGBAFormat, RGFormat, Sphere, UnsignedByteType, Vector3 } from "three";
import { patchBalls, reachPatches } from "./detail.js";
import { splitAtCreases, uniqueEdges } from "./geometry.js";
import { groupsAtLevel, markCovered, markPatches, patchLabels, patchRanges, tint, trianglesByPatch } from "./patches.js";
import { bareMaterial, MAX_SPOTS, plainMaterial, richMaterial, surfaceUniforms, TEXTURE_WIDTH } from "./shading.js";

const shapes = new WeakMap(); // by mesh: bodies that have one share what is drawn of it

function shapeOf(mesh) {
  const patches = mesh.nodeOfPatch.length, labels = patchLabels(mesh);
  const split = splitAtCreases(mesh.positions, mesh.triangles, labels, { normals: mesh.normals });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(split.positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(split.normals, 3));
  geometry.setAttribute("patchNumber", new BufferAttribute(split.labels, 1));
  geometry.setIndex(new BufferAttribute(split.index, 1));
  return { geometry, byPatch: trianglesByPatch(labels, patches), balls: patchBalls(split.positions, split.labels, patches) };
}

/// mesh     as in the `mesh` or `level` message
/// ranges   of the tree that the level's nodes are in (patchRanges); left out: the mesh's own
export function makeSurface(mesh, ranges = patchRanges(mesh.nodeOfPatch, mesh.parents)) {
  if (!shapes.has(mesh)) shapes.set(mesh, shapeOf(mesh));
  const { geometry, byPatch, balls } = shapes.get(mesh), patches = mesh.nodeOfPatch.length;
  const state = new Uint8Array(2 * TEXTURE_WIDTH * textureRows(mesh));
  const patchLevels = patchTexture(state, RGFormat);
  const uniforms = surfaceUniforms(patchLevels);
  const colour = { value: new Color() }, sky = { value: 1 };
  const materials = { rich: richMaterial(uniforms), plain: plainMaterial(uniforms, colour, sky), bare: bareMaterial(colour, sky) };
  materials.rich.color = colour.value;
  const solid = new Mesh(geometry, materials.rich);
  solid.castShadow = solid.receiveShadow = true;
  const lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ transparent: true, opacity: 0.16 }));
  lines.visible = false;
  const stain = makeStain(geometry, materials.plain);
  const group = new Group();
  group.add(solid, stain, lines);
  return { group, solid, stain, lines, rich: true, byPatch, uniforms, geometry, mesh, ranges, materials, colour, sky, state, patchLevels,
    bytes: new Uint8Array(patches), near: new Uint8Array(patches), balls };
}

/// Where patches are coloured the surface is drawn once more, in their colours, by a processor that draws: the rest, which is
/// most of it, costs nothing for them.
function makeStain(geometry, material) {
  const marked = new BufferGeometry();
  for (const [name, attribute] of Object.entries(geometry.attributes)) marked.setAttribute(name, attribute);
  marked.setIndex(new BufferAttribute(new Uint32Array(geometry.index.count), 1).setUsage(DynamicDrawUsage));
  marked.boundingSphere = new Sphere(new Vector3(), Infinity);
  const stain = new Mesh(marked, material);
  stain.renderOrder = 0.5; // after the surface, before what stands on it
  stain.visible = false;
  return stain;
}

/// Puts into the stain the triangles of the patches that have a colour, or may have one near a spot.
function fillStain({ stain, geometry, byPatch: { begin, list }, bytes, near }) {
  const from = geometry.index.array, { index } = stain.geometry;
  let count = 0;
  for (let patch = 0; patch < bytes.length; patch++) {
    if (!bytes[patch] && !near[patch]) continue;
    for (let k = begin[patch]; k < begin[patch + 1]; k++, count += 3) {
      for (let c = 0; c < 3; c++) index.array[count + c] = from[3 * list[k] + c];
    }
  }
  index.clearUpdateRanges();
  index.addUpdateRange(0, count);
  index.needsUpdate = true;
  stain.geometry.setDrawRange(0, count);
}

/// The material that shows all that has to be shown and no more.
function dress(surface) {
  const { solid, stain, materials, uniforms, rich } = surface;
  const isWhole = uniforms.onlyActive.value === 0 && uniforms.tinted.value === 0;
  solid.material = rich ? materials.rich : isWhole ? materials.bare : materials.plain;
  stain.visible = solid.visible && !rich && isWhole && stain.geometry.drawRange.count > 0;
}

const textureRows = (mesh) => Math.max(1, Math.ceil(mesh.nodeOfPatch.length / TEXTURE_WIDTH));
const CHANNELS = new Map([[RedFormat, 1], [RGFormat, 2], [RGBAFormat, 4]]);

function patchTexture(bytes, format) {
  const texture = new DataTexture(bytes, TEXTURE_WIDTH, bytes.length / (TEXTURE_WIDTH * CHANNELS.get(format)), format, UnsignedByteType);
  texture.unpackAlignment = 1;
  texture.needsUpdate = true;
  return texture;
}

/// Every patch in a colour of its own; with a free level of the tree those of one group in the same. null: as it is.
export function tintPatches(surface, level) {
  const { uniforms, mesh } = surface;
  uniforms.tinted.value = level === null ? 0 : 1;
  dress(surface);
  if (level === null || surface.tintedAt === level) return;
  const numbers = mesh.parents ? groupsAtLevel(mesh.nodeOfPatch, mesh.parents, mesh.levels, level) : mesh.nodeOfPatch;
  const bytes = new Uint8Array(4 * TEXTURE_WIDTH * textureRows(mesh));
  numbers.forEach((number, patch) => bytes.set([...tint(Math.max(0, number)), 255], 4 * patch));
  uniforms.patchTints.value?.dispose();
  uniforms.patchTints.value = patchTexture(bytes, RGBAFormat);
  surface.tintedAt = level;
}

/// sky   strength of the light from above, as of the scene's
export function paintSurface(surface, { base, line, sky }) {
  surface.colour.value.set(base);
  surface.sky.value = sky;
  surface.lines.material.color.set(line);
}

/// rich   as MeshStandardMaterial does, else plainly
export function shadeSurface(surface, rich) {
  surface.rich = rich;
  dress(surface);
}

/// solid   "whole", "active": only near contacts, or "none"; lines 0 to 1: how strong edges are drawn
export function showParts(surface, solid, lines) {
  surface.solid.visible = solid !== "none";
  surface.uniforms.onlyActive.value = solid === "active" ? 1 : 0;
  dress(surface);
  surface.lines.visible = lines > 0;
  surface.lines.material.opacity = lines;
  if (lines > 0 && !surface.lines.geometry.index) { // only who looks at lines waits for them
    surface.lines.geometry.setAttribute("position", new BufferAttribute(surface.mesh.positions, 3));
    surface.lines.geometry.setIndex(new BufferAttribute(uniqueEdges(surface.mesh.triangles), 1));
  }
}

/// Colours the patches below the nodes of contacts, and where spots are what lies around them.
/// active   [{node, level}] of the contacts on this object; spots [{point: [x, y, z] in the mesh frame, level}] of them
/// radius   how far around a contact the colour reaches [m]
/// largest  radius of a patch that is coloured whole [m]: where a larger one is touched a spot says
export function markSurface(surface, active, spots, radius, largest) {
  const { bytes, near, balls, state, uniforms } = surface;
  if (surface.mesh.parents) markPatches(surface.ranges, active, bytes);
  else markCovered(surface.ranges, surface.mesh.nodeOfPatch, active, bytes);
  const kept = spots.slice(0, MAX_SPOTS);
  reachPatches(balls, kept, radius, near);
  for (let patch = 0; patch < bytes.length; patch++) {
    if (balls[4 * patch + 3] > largest) bytes[patch] = 0;
    state[2 * patch] = bytes[patch];
    state[2 * patch + 1] = near[patch];
  }
  surface.patchLevels.needsUpdate = true;
  uniforms.spotCount.value = kept.length;
  uniforms.spotRadius.value = radius;
  kept.forEach(({ point, level }, k) => uniforms.spots.value[k].set(...point, level));
  fillStain(surface);
  dress(surface);
}

/// At most MAX_SPOTS of many contacts: one for all that lie within `apart` of each other and have one level.
export function thinSpots(spots, apart, most = MAX_SPOTS) {
  const kept = [];
  for (const spot of spots) {
    if (kept.length === most) break;
    const close = kept.some((other) => other.level === spot.level && distance(other.point, spot.point) < apart);
    if (!close) kept.push(spot);
  }
  return kept;
}

const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

export function disposeSurface(surface) {
  surface.geometry.dispose();
  surface.stain.geometry.dispose();
  surface.patchLevels.dispose();
  surface.uniforms.patchTints.value?.dispose();
  surface.lines.geometry.dispose();
  for (const material of Object.values(surface.materials)) material.dispose();
  surface.lines.material.dispose();
}
