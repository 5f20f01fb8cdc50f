// What is drawn over the objects: force and torque arrows, contacts with their normals, clusters, the felt spring.
import { BufferAttribute, BufferGeometry, Color, ConeGeometry, CylinderGeometry, Group, Mesh,
  MeshBasicMaterial, MeshLambertMaterial, Quaternion, SphereGeometry, TorusGeometry, Vector3 } from "three";
import { clearCopies, makeCopies, putCopy, showCopies } from "./copies.js";
import { plainMark } from "./shading.js";
import { levelColour } from "./theme.js";

export const MAX_CONTACTS = 512;
export const MAX_CLUSTERS = 16;
const Z = new Vector3(0, 0, 1);

/// A material for marks. A second, faint pass without depth test shows them through the objects.
/// light   {value}: strength of the light from above, where a processor draws; else null
export function markMaterial(light, options = {}) {
  return light ? plainMark(light, options) : new MeshLambertMaterial(options);
}
export function seenThrough(light, options = {}) {
  const all = { transparent: true, opacity: 0.42, depthTest: false, depthWrite: false, ...options };
  return light ? plainMark(null, all) : new MeshBasicMaterial(all);
}

/// How many sides a round mark has: a processor that draws takes as long for each of them as for one of the object's.
export const sides = (light, many, few) => (light ? few : many);

/// An arrow along +z of unit length, in parts so that the head keeps its shape.
/// light   as of markMaterial, of all marks
export function makeArrow(light) {
  const group = new Group();
  const shaft = new CylinderGeometry(0.5, 0.5, 1, sides(light, 20, 8)).rotateX(Math.PI / 2).translate(0, 0, 0.5);
  const head = new ConeGeometry(1.35, 3.6, sides(light, 28, 12)).rotateX(Math.PI / 2).translate(0, 0, 1.8);
  const parts = [];
  for (const material of [markMaterial(light), seenThrough(light)]) {
    const a = new Mesh(shaft, material), b = new Mesh(head, material);
    a.renderOrder = b.renderOrder = material.depthTest ? 0 : 20;
    parts.push({ shaft: a, head: b, material });
    group.add(a, b);
  }
  group.visible = false;
  return { group, parts };
}

/// from, along   start and vector in the parent's units; width the thickness of the shaft
export function setArrow(arrow, from, along, width) {
  const length = along.length();
  arrow.group.visible = length > 0.2 * width;
  if (!arrow.group.visible) return;
  arrow.group.position.copy(from);
  arrow.group.quaternion.setFromUnitVectors(Z, along.clone().divideScalar(length));
  const size = Math.min(width, length / 3.6);
  for (const { shaft, head } of arrow.parts) {
    shaft.scale.set(size, size, Math.max(1e-6 * width, length - 3.4 * size));
    head.scale.setScalar(size);
    head.position.set(0, 0, length - 3.6 * size);
  }
}

export function paintArrow(arrow, colour) {
  for (const { material } of arrow.parts) material.color.set(colour);
}

const ARC_THICKNESS = 0.055;

/// A torque: an arc about its axis, counter-clockwise seen from the tip of the vector; the longer, the larger.
export function makeTwist(light) {
  const group = new Group();
  const arc = { steps: sides(light, 72, 36), sides: sides(light, 10, 5) };
  const ring = arcGeometry(arc);
  const head = new ConeGeometry(0.15, 0.38, sides(light, 24, 10));
  const parts = [];
  for (const material of [markMaterial(light), seenThrough(light)]) {
    const a = new Mesh(ring, material), b = new Mesh(head, material);
    a.renderOrder = b.renderOrder = material.depthTest ? 0 : 20;
    parts.push({ ring: a, head: b, material });
    group.add(a, b);
  }
  group.visible = false;
  return { group, parts, ring, arc };
}

/// A tube around the unit circle, ordered along it so that a part can be drawn.
function arcGeometry({ steps, sides: around }) {
  const points = [], normals = [], index = [];
  for (let i = 0; i <= steps; i++) {
    const angle = (2 * Math.PI * i) / steps;
    for (let j = 0; j < around; j++) {
      const turn = (2 * Math.PI * j) / around;
      const outward = Math.cos(turn), upward = Math.sin(turn);
      normals.push(outward * Math.cos(angle), outward * Math.sin(angle), upward);
      const reach = 1 + ARC_THICKNESS * outward;
      points.push(reach * Math.cos(angle), reach * Math.sin(angle), ARC_THICKNESS * upward);
      const next = (j + 1) % around;
      if (i < steps) {
        const a = i * around + j, b = i * around + next;
        index.push(a, b, a + around, b, b + around, a + around);
      }
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(points), 3));
  geometry.setAttribute("normal", new BufferAttribute(Float32Array.from(normals), 3));
  geometry.setIndex(index);
  return geometry;
}

/// share   of a turn of 300 degrees, 0 to 1
export function setTwist(twist, at, axis, share, radius) {
  twist.group.visible = share > 0.01 && axis.lengthSq() > 0;
  if (!twist.group.visible) return;
  twist.group.position.copy(at);
  twist.group.quaternion.setFromUnitVectors(Z, axis.clone().normalize());
  twist.group.scale.setScalar(radius);
  const steps = Math.max(1, Math.round((300 / 360) * twist.arc.steps * Math.min(1, share)));
  twist.ring.setDrawRange(0, steps * twist.arc.sides * 6);
  const angle = (2 * Math.PI * steps) / twist.arc.steps;
  for (const { head } of twist.parts) {
    head.position.set(Math.cos(angle), Math.sin(angle), 0);
    head.rotation.set(0, 0, angle);
    head.scale.setScalar(Math.min(1, 0.25 + 4 * share));
  }
}

export function paintTwist(twist, colour) {
  for (const { material } of twist.parts) material.color.set(colour);
}

/// Contacts as dots with normals, clusters as rings; both also faintly through the objects.
export function makeContactMarks(light) {
  const group = new Group();
  const dot = new SphereGeometry(1, sides(light, 8, 5), sides(light, 6, 3));
  const needle = new CylinderGeometry(0.22, 0.22, 1, sides(light, 5, 3), 1, Boolean(light)).rotateX(Math.PI / 2).translate(0, 0, 0.5);
  const ring = new TorusGeometry(1, 0.12, sides(light, 5, 3), sides(light, 28, 16));
  const both = (shape, most, opacity, order) => makeCopies(group, shape, most, [[markMaterial(light), 1], [seenThrough(light, { opacity }), order]]);
  return { group, dots: both(dot, MAX_CONTACTS, 0.45, 21), needles: both(needle, MAX_CONTACTS, 0.45, 21), rings: both(ring, MAX_CLUSTERS, 0.55, 22) };
}

const turn = new Quaternion(), place = new Vector3(), scale = new Vector3(), tint = new Color();

/// contacts   [{point, normal, level}], clusters [{point, normal, share 0 to 1}] in the parent's frame; size of a dot
export function setContactMarks(marks, contacts, clusters, size, ringColour) {
  const { dots, needles, rings } = marks;
  for (const copies of [dots, needles, rings]) clearCopies(copies);
  for (const { point, normal, level } of contacts.slice(0, MAX_CONTACTS)) {
    place.set(...point);
    turn.setFromUnitVectors(Z, scale.set(...normal).normalize());
    tint.set(levelColour(level));
    putCopy(dots, place, turn, scale.set(size, size, size), tint);
    putCopy(needles, place, turn, scale.set(size, size, 5.5 * size), tint);
  }
  tint.set(ringColour);
  for (const { point, normal, share } of clusters.slice(0, MAX_CLUSTERS)) {
    place.set(...point);
    turn.setFromUnitVectors(Z, scale.set(...normal).normalize());
    const wide = size * (2.6 + 2.4 * Math.sqrt(Math.max(0, Math.min(1, share))));
    putCopy(rings, place, turn, scale.set(wide, wide, wide), tint);
  }
  for (const copies of [dots, needles, rings]) showCopies(copies);
}

/// A thin rod between two points, for the spring between the hand and the object.
export function makeRod(light) {
  const material = markMaterial(light);
  const through = seenThrough(light, { opacity: 0.5 });
  const group = new Group();
  const geometry = new CylinderGeometry(1, 1, 1, sides(light, 10, 6)).rotateX(Math.PI / 2).translate(0, 0, 0.5);
  const ends = new SphereGeometry(1, sides(light, 16, 8), sides(light, 12, 6));
  const rods = [], knobs = [];
  for (const m of [material, through]) {
    const rod = new Mesh(geometry, m), knob = new Mesh(ends, m);
    rod.renderOrder = knob.renderOrder = m.depthTest ? 0 : 23;
    rods.push(rod);
    knobs.push(knob);
    group.add(rod, knob);
  }
  return { group, rods, knobs, materials: [material, through] };
}

export function setRod(rod, from, to, width) {
  const along = to.clone().sub(from), length = along.length();
  rod.group.position.copy(from);
  if (length > 0) rod.group.quaternion.setFromUnitVectors(Z, along.divideScalar(length));
  for (const mesh of rod.rods) mesh.scale.set(width, width, Math.max(length, 1e-9 * width));
  for (const mesh of rod.knobs) {
    mesh.position.set(0, 0, length);
    mesh.scale.setScalar(2.6 * width);
  }
}

export function paintRod(rod, colour) {
  for (const material of rod.materials) material.color.set(colour);
}
