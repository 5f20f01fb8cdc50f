// How a surface is shaded: as MeshStandardMaterial does, or plainly, for a processor that draws; both with the same colours
// near contacts.
import { Color, MeshStandardMaterial, ShaderMaterial, Vector3, Vector4 } from "three";
import { KEY, RIM } from "./lights.js";
import { LEVEL_COLOURS, levelColour } from "./theme.js";

export const MAX_SPOTS = 24;
export const TEXTURE_WIDTH = 1024; // patches beside each other

/// What the shaders of one object read.
/// patchLevels   two bytes a patch: active level + 1, or 0 for none; 255 where a spot may reach
export function surfaceUniforms(patchLevels) {
  return {
    patchLevels: { value: patchLevels },
    spotCount: { value: 0 },
    spotRadius: { value: 1 },
    spots: { value: Array.from({ length: MAX_SPOTS }, () => new Vector4()) }, // point [mesh frame], level
    levelColours: { value: LEVEL_COLOURS.map((_, level) => new Color(levelColour(level))) },
    onlyActive: { value: 0 }, // 1: nothing but the coloured parts is drawn
    patchTints: { value: null }, // a colour a patch, of the level browser
    tinted: { value: 0 }, // 1: every patch in its colour of patchTints
  };
}

// A vertex belongs to one patch, so what is known of the patch is read once a vertex, not once a pixel.
const VERTEX_HEAD = `attribute float patchNumber;
uniform sampler2D patchLevels;
uniform sampler2D patchTints;
uniform float tinted;
varying vec3 meshPoint;
flat varying vec2 patchState;
flat varying vec4 patchTint;`;
const VERTEX_BODY = `meshPoint = position;
patchState = vec2(0.0);
patchTint = vec4(0.0);
if (patchNumber >= 0.0) {
  int patchIndex = int(patchNumber + 0.5);
  ivec2 cell = ivec2(patchIndex % ${TEXTURE_WIDTH}, patchIndex / ${TEXTURE_WIDTH});
  patchState = floor(texelFetch(patchLevels, cell, 0).rg * 255.0 + 0.5);
  if (tinted > 0.5) patchTint = vec4(texelFetch(patchTints, cell, 0).rgb, 1.0);
}`;
const FRAGMENT_HEAD = `varying vec3 meshPoint;
flat varying vec2 patchState;
flat varying vec4 patchTint;
uniform int spotCount;
uniform float spotRadius;
uniform float onlyActive;
uniform vec4 spots[${MAX_SPOTS}];
uniform vec3 levelColours[${LEVEL_COLOURS.length}];
/// The colour of a point of the surface: its own, of its patch, or of a contact nearby.
vec3 markedColour(vec3 base) {
  int level = int(patchState.x) - 1;
  float share = level >= 0 ? 0.92 : 0.0;
  if (level < 0 && patchState.y > 0.5) {
    float nearest = 1.0;
    for (int k = 0; k < ${MAX_SPOTS}; k++) {
      if (k >= spotCount) break;
      float d = distance(meshPoint, spots[k].xyz) / spotRadius;
      if (d < nearest) { nearest = d; level = int(spots[k].w); }
    }
    share = 0.85 * (1.0 - smoothstep(0.3, 1.0, nearest));
  }
  if (onlyActive > 0.5 && share < 0.02) discard;
  vec3 tone = levelColours[clamp(level, 0, ${LEVEL_COLOURS.length - 1})];
  if (patchTint.a > 0.5) return mix(patchTint.rgb, tone, 0.75 * step(0.9, share));
  return mix(base, tone, share);
}`;

/// A standard material; patches in contact take the colour of their level, what lies within spotRadius of one on a large
/// patch a hue of it.
export function richMaterial(uniforms) {
  const material = new MeshStandardMaterial({ roughness: 0.62, metalness: 0.0 });
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader = shader.vertexShader.replace("#include <common>", `#include <common>\n${VERTEX_HEAD}`)
      .replace("#include <begin_vertex>", `#include <begin_vertex>\n${VERTEX_BODY}`);
    shader.fragmentShader = shader.fragmentShader.replace("#include <common>", `#include <common>\n${FRAGMENT_HEAD}`)
      .replace("#include <color_fragment>", "#include <color_fragment>\ndiffuseColor.rgb = markedColour(diffuseColor.rgb);");
  };
  return material;
}

const glsl = (v) => `vec3(${v.map((x) => x.toFixed(5)).join(", ")})`;
const direction = ({ from }) => glsl(new Vector3(...from).normalize().toArray());

// The same lights without highlights and shadows: a seventh of the time where the processor draws.
const PLACE = "gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);";
const FACING = "mat3(modelMatrix) * normal";
const PLAIN_HEAD = `uniform vec3 base;
uniform float sky;
/// A colour as the screen takes it: roots in place of a power, which costs a processor more than all the rest (within a two
/// hundredth of it, from black to white).
vec3 screenColour(vec3 lit) {
  float peak = max(lit.r, max(lit.g, lit.b)), over = peak - 0.76; // bright ones flatten out, as by NeutralToneMapping
  if (over > 0.0) lit *= (1.0 - 0.0576 / (over + 0.24)) / peak;
  vec3 half_ = sqrt(lit), quarter = sqrt(half_), eighth = sqrt(quarter);
  return 0.662 * half_ + 0.6841 * quarter - 0.3236 * eighth - 0.0225 * lit;
}
/// facing   normal of the surface, any length [world]
vec3 litColour(vec3 colour, vec3 facing) {
  vec3 n = normalize(facing);
  vec3 light = mix(vec3(0.25, 0.22, 0.19), vec3(1.0), 0.5 + 0.5 * n.z) * sky + ${KEY.strength.toFixed(3)} * ${glsl(KEY.tone)} * max(0.0, dot(n, ${direction(KEY)}))
    + ${RIM.strength.toFixed(3)} * ${glsl(RIM.tone)} * max(0.0, dot(n, ${direction(RIM)})) + 0.28;
  return screenColour(colour * light * 0.31831);
}`;

/// Of one colour, lit at its corners: of each pixel it cost half of a picture.
/// colour, sky   {value}: of the object; strength of the light from above
export function bareMaterial(colour, sky) {
  return new ShaderMaterial({
    uniforms: { base: colour, sky },
    vertexShader: `${PLAIN_HEAD}
varying vec3 lit;
invariant gl_Position;
void main() {
  lit = litColour(base, ${FACING});
  ${PLACE}
}`,
    fragmentShader: `varying vec3 lit;
void main() {
  gl_FragColor = vec4(lit, 1.0);
}`,
  });
}

/// The same with colours near contacts and of patches; to the last bit at the same depth, so that it may lie on the bare one.
export function plainMaterial(uniforms, colour, sky) {
  return new ShaderMaterial({
    uniforms: { ...uniforms, base: colour, sky },
    vertexShader: `${VERTEX_HEAD}
varying vec3 facing;
invariant gl_Position;
void main() {
  ${VERTEX_BODY}
  facing = ${FACING};
  ${PLACE}
}`,
    fragmentShader: `${FRAGMENT_HEAD}
${PLAIN_HEAD}
varying vec3 facing;
void main() {
  gl_FragColor = vec4(litColour(markedColour(base), facing), 1.0);
}`,
  });
}

/// Of marks, lit at their corners as well: a colour, times one of each corner where there are such.
/// light     {value}: strength of the light from above; null: a colour without light
/// options   of the material; opacity
export function plainMark(light, { opacity = 1, ...options } = {}) {
  const color = new Color(1, 1, 1);
  const material = new ShaderMaterial({ ...options,
    uniforms: { base: { value: color }, sky: light ?? { value: 0 }, opacity: { value: opacity } },
    vertexShader: `${PLAIN_HEAD}
varying vec3 lit;
void main() {
  vec3 tone = base;
#ifdef USE_COLOR
  tone *= color;
#endif
  ${PLACE}
${light ? `  vec3 facing = ${FACING};
#ifdef DOUBLE_SIDED
  vec3 seen = (modelViewMatrix * vec4(position, 1.0)).xyz;
  if (dot(mat3(viewMatrix) * facing, seen) > 0.0) facing = -facing;
#endif
  lit = litColour(tone, facing);` : "  lit = screenColour(tone);"}
}`,
    fragmentShader: `varying vec3 lit; uniform float opacity;
void main() { gl_FragColor = vec4(lit, opacity); }` });
  return Object.assign(material, { color });
}
