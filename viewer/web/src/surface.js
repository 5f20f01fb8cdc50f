// One surface as drawn: coloured near the contacts by their level of detail, its triangles perhaps as lines.
import { BufferAttribute, BufferGeometry, Color, DataTexture, Group, LineBasicMaterial, LineSegments, Mesh, RedFormat,
  RGBAFormat, RGFormat, UnsignedByteType } from "three";
import { patchBalls, reachPatches } from "./detail.js";
import { splitAtCreases, uniqueEdges } from "./geometry.js";
import { groupsAtLevel, markCovered, markPatches, patchOf, patchRanges, tint } from "./patches.js";
import { MAX_SPOTS, plainMaterial, richMaterial, surfaceUniforms, TEXTURE_WIDTH } from "./shading.js";

/// mesh     as in the `mesh` or `level` message
/// ranges   of the tree that the level's nodes are in (patchRanges); left out: the mesh's own
export function makeSurface(mesh, ranges = patchRanges(mesh.nodeOfPatch, mesh.parents)) {
  const triangles = mesh.triangles.length / 3, patches = mesh.nodeOfPatch.length;
  const labels = Float32Array.from({ length: triangles }, (_, t) => patchOf(mesh, t));
  const split = splitAtCreases(mesh.positions, mesh.triangles, labels);
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(split.positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(split.normals, 3));
  geometry.setAttribute("patchNumber", new BufferAttribute(split.labels, 1));
  geometry.setIndex(new BufferAttribute(split.index, 1));

  const state = new Uint8Array(2 * TEXTURE_WIDTH * textureRows(mesh));
  const patchLevels = patchTexture(state, RGFormat);
  const uniforms = surfaceUniforms(patchLevels);
  const colour = { value: new Color() }, sky = { value: 1 };
  const materials = { rich: richMaterial(uniforms), plain: plainMaterial(uniforms, colour, sky) };
  materials.rich.color = colour.value;
  const solid = new Mesh(geometry, materials.rich);
  solid.castShadow = solid.receiveShadow = true;
  const lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ transparent: true, opacity: 0.16 }));
  lines.visible = false;
  const group = new Group();
  group.add(solid, lines);
  return { group, solid, lines, uniforms, geometry, mesh, ranges, materials, colour, sky, state, patchLevels,
    bytes: new Uint8Array(patches), near: new Uint8Array(patches), balls: patchBalls(split.positions, split.labels, patches) };
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
  surface.solid.material = rich ? surface.materials.rich : surface.materials.plain;
}

/// solid   "whole", "active": only near contacts, or "none"; lines 0 to 1: how strong edges are drawn
export function showParts(surface, solid, lines) {
  surface.solid.visible = solid !== "none";
  surface.uniforms.onlyActive.value = solid === "active" ? 1 : 0;
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
  surface.patchLevels.dispose();
  surface.uniforms.patchTints.value?.dispose();
  surface.lines.geometry.dispose();
  for (const material of Object.values(surface.materials)) material.dispose();
  surface.lines.material.dispose();
}
