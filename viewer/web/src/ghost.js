// The ghost of the hand, and how far it stands from the object.
import { Color, Group, Mesh, NoBlending, Quaternion, ShaderMaterial } from "three";

/// A twin of glass, brighter at its rim: first its depth alone, then its nearest surface, so that nothing of its inside
/// shows. It is drawn over all else, as it mostly hides in what it presses against: in front of it by the range of its depth,
/// as clearing the depth of all else cost a picture of its own where the processor draws. Its rim is of the corners, not of
/// each pixel, for the same reason.
export function makeGhost(geometry) {
  const group = new Group();
  const hidden = new Mesh(geometry, new ShaderMaterial({ colorWrite: false, transparent: true, blending: NoBlending,
    vertexShader: "void main() { gl_Position = projectionMatrix * (modelViewMatrix * vec4(position, 1.0)); }",
    fragmentShader: "void main() { gl_FragColor = vec4(0.0); }" }));
  const glass = new Mesh(geometry, new ShaderMaterial({
    transparent: true, depthWrite: false, uniforms: { tone: { value: new Color() } },
    vertexShader: `varying float opacity;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  float rim = 1.0 - abs(dot(normalize(normalMatrix * normal), normalize(-seen.xyz)));
  opacity = 0.10 + 0.55 * rim * rim * rim;
  gl_Position = projectionMatrix * seen;
}`,
    fragmentShader: `varying float opacity; uniform vec3 tone;
void main() { gl_FragColor = vec4(tone, opacity); }` }));
  for (const mesh of [hidden, glass]) {
    mesh.onBeforeRender = (renderer) => renderer.getContext().depthRange(0, NEAREST);
    mesh.onAfterRender = (renderer) => renderer.getContext().depthRange(0, 1);
  }
  hidden.renderOrder = 10;
  glass.renderOrder = 11;
  group.add(hidden, glass);
  group.visible = false;
  return { group, hidden, glass };
}
const NEAREST = 0.01; // of the depths: what else is so near is cut off by the eye

/// The tone is as the screen takes it: nothing is left to do for each of its pixels.
export function paintGhost({ glass }, colour) {
  glass.material.uniforms.tone.value.set(colour).convertLinearToSRGB();
}

/// It is drawn as finely as its object.
export function shapeGhost(ghost, geometry) {
  ghost.hidden.geometry = ghost.glass.geometry = geometry;
}

/// How far the ghost stands from the object: the way, in radii, and the turn.
export function apart({ object, ghost }, size) {
  const way = Math.hypot(...object.position.map((value, k) => value - ghost.position[k]));
  const a = new Quaternion(...object.quaternion), b = new Quaternion(...ghost.quaternion);
  return way / size + a.angleTo(b);
}
