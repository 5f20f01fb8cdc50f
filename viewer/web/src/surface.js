// One object as drawn: its surface, coloured near the contacts by their level of detail, and its finest triangles as lines.
import { BufferAttribute, BufferGeometry, Color, DataTexture, Group, LineBasicMaterial, LineSegments, Mesh,
  MeshStandardMaterial, RedFormat, RGBAFormat, UnsignedByteType, Vector4 } from "three";
import { splitAtCreases, uniqueEdges } from "./geometry.js";
import { groupsAtLevel, markNodes, markPatches, patchOf, patchRanges, tint } from "./patches.js";
import { LEVEL_COLOURS, levelColour } from "./theme.js";

export const MAX_SPOTS = 24;
const TEXTURE_WIDTH = 1024;

/// What the shader of one object reads.
function surfaceUniforms(patchLevels) {
  return {
    patchLevels: { value: patchLevels }, // a byte a patch: active level + 1, 0 for none
    spotCount: { value: 0 },
    spotRadius: { value: 1 },
    spots: { value: Array.from({ length: MAX_SPOTS }, () => new Vector4()) }, // point [mesh frame], level
    levelColours: { value: LEVEL_COLOURS.map((_, level) => new Color(levelColour(level))) },
    onlyActive: { value: 0 }, // 1: nothing but the coloured parts is drawn
    patchTints: { value: null }, // a colour a patch, of the level browser
    tinted: { value: 0 }, // 1: every patch in its colour of patchTints
  };
}

/// A standard material; patches in contact take the colour of their level, their surroundings within spotRadius a hue of it.
function surfaceMaterial(uniforms) {
  const material = new MeshStandardMaterial({ roughness: 0.62, metalness: 0.0 });
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", "#include <common>\nattribute float patchNumber;\nvarying vec3 meshPoint;\nflat varying float onPatch;")
      .replace("#include <begin_vertex>", "#include <begin_vertex>\nmeshPoint = position;\nonPatch = patchNumber;");
    shader.fragmentShader = shader.fragmentShader
      .replace("#include <common>", `#include <common>
varying vec3 meshPoint;
flat varying float onPatch;
uniform sampler2D patchLevels;
uniform int spotCount;
uniform float spotRadius;
uniform float onlyActive;
uniform sampler2D patchTints;
uniform float tinted;
uniform vec4 spots[${MAX_SPOTS}];
uniform vec3 levelColours[${LEVEL_COLOURS.length}];`)
      .replace("#include <color_fragment>", `#include <color_fragment>
{
  float nearest = 1.0;
  int level = 0;
  for (int k = 0; k < ${MAX_SPOTS}; k++) {
    if (k >= spotCount) break;
    float d = distance(meshPoint, spots[k].xyz) / spotRadius;
    if (d < nearest) { nearest = d; level = int(spots[k].w); }
  }
  float share = 0.5 * (1.0 - smoothstep(0.35, 1.0, nearest));
  int patchIndex = int(onPatch + 0.5);
  if (onPatch >= 0.0) {
    float stored = texelFetch(patchLevels, ivec2(patchIndex % ${TEXTURE_WIDTH}, patchIndex / ${TEXTURE_WIDTH}), 0).r;
    int levelPlusOne = int(stored * 255.0 + 0.5);
    if (levelPlusOne > 0) { share = 0.92; level = levelPlusOne - 1; }
  }
  if (onlyActive > 0.5 && share < 0.02) discard;
  level = min(level, ${LEVEL_COLOURS.length - 1});
  diffuseColor.rgb = mix(diffuseColor.rgb, levelColours[level], share);
  if (tinted > 0.5 && onPatch >= 0.0) {
    vec3 own = texelFetch(patchTints, ivec2(patchIndex % ${TEXTURE_WIDTH}, patchIndex / ${TEXTURE_WIDTH}), 0).rgb;
    diffuseColor.rgb = mix(own, levelColours[level], 0.75 * step(0.9, share));
  }
}`);
  };
  return material;
}

/// mesh   as in the `mesh` message
export function makeSurface(mesh) {
  const triangles = mesh.triangles.length / 3;
  const labels = Float32Array.from({ length: triangles }, (_, t) => patchOf(mesh, t));
  const split = splitAtCreases(mesh.positions, mesh.triangles, labels);
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(split.positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(split.normals, 3));
  geometry.setAttribute("patchNumber", new BufferAttribute(split.labels, 1));
  geometry.setIndex(new BufferAttribute(split.index, 1));
  const lineGeometry = new BufferGeometry();
  lineGeometry.setAttribute("position", new BufferAttribute(mesh.positions, 3));
  lineGeometry.setIndex(new BufferAttribute(uniqueEdges(mesh.triangles), 1));

  const bytes = new Uint8Array(TEXTURE_WIDTH * textureRows(mesh));
  const patchLevels = patchTexture(bytes, RedFormat);
  const uniforms = surfaceUniforms(patchLevels);
  const solid = new Mesh(geometry, surfaceMaterial(uniforms));
  solid.castShadow = solid.receiveShadow = true;
  const lines = new LineSegments(lineGeometry, new LineBasicMaterial({ transparent: true, opacity: 0.16 }));
  lines.visible = false;
  const group = new Group();
  group.add(solid, lines);
  // A simplified level comes without a tree: its patches are named by their nodes.
  const ranges = mesh.parents ? patchRanges(mesh.nodeOfPatch, mesh.parents) : null;
  return { group, solid, lines, uniforms, geometry, mesh, ranges, bytes, patchLevels };
}

const textureRows = (mesh) => Math.max(1, Math.ceil(mesh.nodeOfPatch.length / TEXTURE_WIDTH));

function patchTexture(bytes, format) {
  const texture = new DataTexture(bytes, TEXTURE_WIDTH, bytes.length / (TEXTURE_WIDTH * (format === RGBAFormat ? 4 : 1)), format,
    UnsignedByteType);
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

export function paintSurface(surface, base, line) {
  surface.solid.material.color.set(base);
  surface.lines.material.color.set(line);
}

/// solid   "whole", "active": only near contacts, or "none"; lines 0 to 1: how strong edges are drawn
export function showParts(surface, solid, lines) {
  surface.solid.visible = solid !== "none";
  surface.uniforms.onlyActive.value = solid === "active" ? 1 : 0;
  surface.lines.visible = lines > 0;
  surface.lines.material.opacity = lines;
}

/// active   [{node, level}] of the contacts on this object
export function setActive(surface, active) {
  if (surface.ranges) markPatches(surface.ranges, active, surface.bytes);
  else markNodes(surface.mesh.nodeOfPatch, active, surface.bytes);
  surface.patchLevels.needsUpdate = true;
}

/// spots    [{point: [x, y, z] in the mesh frame, level}]
/// radius   how far around a contact the colour reaches [m]
export function setSpots(surface, spots, radius) {
  const { uniforms } = surface;
  uniforms.spotCount.value = Math.min(MAX_SPOTS, spots.length);
  uniforms.spotRadius.value = radius;
  for (let k = 0; k < uniforms.spotCount.value; k++) uniforms.spots.value[k].set(...spots[k].point, spots[k].level);
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
  surface.solid.material.dispose();
  surface.lines.material.dispose();
}
