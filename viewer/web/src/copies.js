// Many small copies of one shape, each in a place and a colour of its own, as one geometry. Instances would do on graphics
// hardware; a processor that draws takes as long for each of them as for an object.
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Mesh, Sphere, Vector3 } from "three";

/// materials   [[material, render order]]: the copies are drawn once with each
/// returns     with room for `most`; none is there yet
export function makeCopies(group, shape, most, materials) {
  const { position, normal } = shape.attributes, vertices = position.count;
  const geometry = new BufferGeometry();
  for (const name of ["position", "normal", "color"]) {
    geometry.setAttribute(name, new BufferAttribute(new Float32Array(3 * vertices * most), 3).setUsage(DynamicDrawUsage));
  }
  const index = new Uint32Array(shape.index.count * most);
  for (let k = 0; k < index.length; k++) index[k] = shape.index.array[k % shape.index.count] + vertices * Math.floor(k / shape.index.count);
  geometry.setIndex(new BufferAttribute(index, 1));
  geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
  const meshes = materials.map(([material, order]) => {
    material.vertexColors = true;
    const mesh = new Mesh(geometry, material);
    mesh.renderOrder = order;
    mesh.visible = false;
    group.add(mesh);
    return mesh;
  });
  return { geometry, meshes, most, count: 0, position: position.array, normal: normal.array, perCopy: shape.index.count };
}

export function clearCopies(copies) {
  copies.count = 0;
}

/// turn   a unit quaternion; scale   of the shape along its own axes, none 0
export function putCopy(copies, place, turn, scale, colour) {
  if (copies.count === copies.most) return;
  const { position, normal, geometry: { attributes } } = copies, from = position.length * copies.count;
  for (let k = 0; k < position.length; k += 3) {
    put(attributes.position.array, from + k, position[k] * scale.x, position[k + 1] * scale.y, position[k + 2] * scale.z, turn, place);
    put(attributes.normal.array, from + k, normal[k] / scale.x, normal[k + 1] / scale.y, normal[k + 2] / scale.z, turn, ORIGIN);
    attributes.color.array[from + k] = colour.r;
    attributes.color.array[from + k + 1] = colour.g;
    attributes.color.array[from + k + 2] = colour.b;
  }
  copies.count += 1;
}
const ORIGIN = new Vector3();

/// (x, y, z) turned, then shifted. A normal comes out of any length; shaders bring it to 1.
function put(array, at, x, y, z, turn, shift) {
  const tx = 2 * (turn.y * z - turn.z * y), ty = 2 * (turn.z * x - turn.x * z), tz = 2 * (turn.x * y - turn.y * x);
  array[at] = x + turn.w * tx + turn.y * tz - turn.z * ty + shift.x;
  array[at + 1] = y + turn.w * ty + turn.z * tx - turn.x * tz + shift.y;
  array[at + 2] = z + turn.w * tz + turn.x * ty - turn.y * tx + shift.z;
}

/// After the last one.
export function showCopies({ geometry, meshes, position, count, perCopy }) {
  for (const mesh of meshes) mesh.visible = count > 0;
  geometry.setDrawRange(0, perCopy * count);
  for (const attribute of Object.values(geometry.attributes)) {
    attribute.clearUpdateRanges();
    attribute.addUpdateRange(0, position.length * count);
    attribute.needsUpdate = count > 0;
  }
}
