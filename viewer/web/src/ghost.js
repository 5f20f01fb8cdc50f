// The ghost of the hand, and how far it stands from the object.
import { Color, Group, Mesh, MeshBasicMaterial, Quaternion, ShaderMaterial } from "three";

/// A twin of glass, brighter at its rim: first its depth alone, then its nearest surface, so that nothing of its inside
/// shows. It is drawn over all else, as it mostly hides in what it presses against.
export function makeGhost(geometry) {
  const group = new Group();
  const hidden = new Mesh(geometry, new MeshBasicMaterial({ colorWrite: false, transparent: true }));
  hidden.onBeforeRender = (renderer) => renderer.clearDepth();
  const glass = new Mesh(geometry, new ShaderMaterial({
    transparent: true, depthWrite: false, uniforms: { tone: { value: new Color() } },
    vertexShader: `varying vec3 facing; varying vec3 toEye;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  facing = normalize(normalMatrix * normal);
  toEye = -seen.xyz;
  gl_Position = projectionMatrix * seen;
}`,
    fragmentShader: `varying vec3 facing; varying vec3 toEye; uniform vec3 tone;
void main() {
  float rim = 1.0 - abs(dot(normalize(facing), normalize(toEye)));
  gl_FragColor = vec4(tone, 0.10 + 0.55 * rim * rim * rim);
}` }));
  hidden.renderOrder = 10;
  glass.renderOrder = 11;
  group.add(hidden, glass);
  group.visible = false;
  return { group, hidden, glass };
}

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
