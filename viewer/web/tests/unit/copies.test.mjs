import assert from "node:assert/strict";
import { test } from "node:test";
import { Color, ConeGeometry, Group, Matrix3, Matrix4, MeshBasicMaterial, Quaternion, Vector3 } from "three";
import { clearCopies, makeCopies, putCopy, showCopies } from "../../src/copies.js";

test("each copy stands where a matrix would put it, with its normals and its colour, and no more than there is room for", () => {
  const shape = new ConeGeometry(1, 2, 5), group = new Group(), vertices = shape.attributes.position.count;
  const copies = makeCopies(group, shape, 3, [[new MeshBasicMaterial(), 1], [new MeshBasicMaterial(), 7]]);
  assert.deepEqual(group.children.map(({ visible, renderOrder }) => [visible, renderOrder]), [[false, 1], [false, 7]]);
  let seed = 3;
  const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647 - 0.5;
  const put = [];
  for (let k = 0; k < 4; k++) {
    const place = new Vector3(random(), random(), random()), turn = new Quaternion(random(), random(), random(), random()).normalize();
    const scale = new Vector3(1 + random(), 1 + random(), 1 + random()), colour = new Color(k / 4, 0.5, 1);
    put.push({ matrix: new Matrix4().compose(place, turn, scale), colour });
    putCopy(copies, place, turn, scale, colour);
  }
  showCopies(copies);
  assert.equal(copies.count, 3);
  const { position, normal, color } = copies.geometry.attributes, at = (attribute, v) => new Vector3().fromBufferAttribute(attribute, v);
  assert.equal(copies.geometry.drawRange.count, 3 * shape.index.count);
  for (let k = 0; k < 3; k++) {
    const { matrix, colour } = put[k], turned = new Matrix3().getNormalMatrix(matrix);
    for (let v = 0; v < vertices; v++) {
      assert.ok(at(position, k * vertices + v).distanceTo(at(shape.attributes.position, v).applyMatrix4(matrix)) < 1e-6);
      assert.ok(at(normal, k * vertices + v).normalize().distanceTo(at(shape.attributes.normal, v).applyMatrix3(turned).normalize()) < 1e-5);
      assert.deepEqual(at(color, k * vertices + v).toArray(), new Vector3(...colour.toArray().map(Math.fround)).toArray());
    }
    const index = [...copies.geometry.index.array.slice(k * shape.index.count, (k + 1) * shape.index.count)];
    assert.deepEqual(index, [...shape.index.array].map((v) => v + k * vertices));
  }
  clearCopies(copies);
  showCopies(copies);
  assert.ok(group.children.every(({ visible }) => !visible), "nothing is drawn of none");
});
