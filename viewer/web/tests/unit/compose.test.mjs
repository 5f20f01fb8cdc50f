import assert from "node:assert/strict";
import { test } from "node:test";
import { added, angleBetween, changed, commit, composeMessage, fromAngles, inHand, makeComposition, redo, revert, takeScene, toAngles, undo, without } from "../../src/compose.js";
import { aboutAxis, multiply } from "../../src/hand.js";

const SCENE = { title: "Two", object: { name: "a", source: "scene:0", unit: 0.001, radius: 0.02, center: [0.01, 0, 0], mass: 0.02 },
  start: { position: [0, 0, 0.1], quat_xyzw: [0, 0, 0, 1] },
  statics: [{ name: "b", source: "scene:1", unit: 1, radius: 0.05, center: [0, 0, 0], friction: 0.3, position: [0.2, 0, 0], quat_xyzw: [0, 0, 1, 0] }] };

function made() {
  const composition = makeComposition();
  takeScene(composition, SCENE, false);
  return composition;
}

test("what the program shows is what is asked for, unchanged", () => {
  const { title, objects, type } = composeMessage(made());
  assert.deepEqual([type, title], ["compose", "Two"]);
  assert.deepEqual(objects, [
    { source: "scene:0", name: "a", unit: 0.001, position: [0, 0, 0.1], quat_xyzw: [0, 0, 0, 1], friction: null, mass: 0.02, density: null },
    { source: "scene:1", name: "b", unit: 1, position: [0.2, 0, 0], quat_xyzw: [0, 0, 1, 0], friction: 0.3 }]);
});

test("every step is undone and done again, and a refused one leaves no trace", () => {
  const composition = made(), first = composition.objects;
  commit(composition, changed(composition.objects, 1, { friction: 0.5 }));
  commit(composition, without(composition.objects, 1));
  composition.chosen = 1;
  assert.ok(undo(composition) && composition.objects[1].friction === 0.5);
  assert.ok(undo(composition) && composition.objects === first && !undo(composition));
  assert.ok(redo(composition) && redo(composition) && composition.objects.length === 1 && !redo(composition));
  assert.equal(composition.chosen, 0, "what is chosen is there");
  commit(composition, changed(composition.objects, 0, { name: "x" }));
  revert(composition);
  assert.deepEqual([composition.objects[0].name, composition.objects.length], ["a", 1]);
  undo(composition);
  commit(composition, changed(composition.objects, 0, { name: "y" }));
  assert.ok(!redo(composition), "another way has been taken");
});

test("the program's answer keeps the steps, another scene forgets them", () => {
  const composition = made();
  commit(composition, changed(composition.objects, 1, { friction: 0.5 }));
  takeScene(composition, SCENE, true);
  assert.equal(composition.done.length, 1);
  takeScene(composition, SCENE, false);
  assert.equal(composition.done.length, 0);
  for (let k = 0; k < 500; k++) commit(composition, changed(composition.objects, 0, { mass: k }));
  assert.ok(composition.done.length <= 100, "memory is bounded");
});

test("a mesh that is dropped stands beside what is there, in its unit", () => {
  const model = { number: 7, name: "cup.big.stl", report: { bounds: { min: [-10, -20, 0], max: [30, 20, 40] } } };
  const [, , cup] = added(made().objects, model, 0.001, SCENE);
  assert.deepEqual([cup.source, cup.name, cup.unit, cup.size], ["file:7", "cup.big", 0.001, 0.04]);
  const left = cup.position[0] - 0.01; // its bounds there
  assert.ok(left > 0.25 && left < 0.26, `${left}`);
  assert.ok(Math.abs(cup.position[2] + 0.02) < 1e-12 && cup.position[1] === 0, "its middle at the height of the others' origin");
  assert.equal(added([], model, 1, null)[0].position[0], -10, "alone it is in the middle");
});

test("another object comes into the hand", () => {
  const { objects } = made();
  assert.deepEqual(inHand(objects, 1).map(({ name }) => name), ["b", "a"]);
});

test("angles about x, y, z are those of the turn, both ways", () => {
  const [x, y, z] = [0.3, -0.7, 2.1];
  const q = multiply(aboutAxis([0, 0, 1], z), multiply(aboutAxis([0, 1, 0], y), aboutAxis([1, 0, 0], x)));
  toAngles(q).forEach((value, k) => assert.ok(Math.abs(value - [x, y, z][k] * 180 / Math.PI) < 1e-9));
  for (let k = 0; k < 400; k++) {
    const angles = [0, 1, 2].map((axis) => ((k * (37 + 11 * axis)) % 360) - 180);
    if (k % 10 === 0) angles[1] = k % 20 === 0 ? 90 : -90; // where x and z turn the same
    const turn = fromAngles(angles);
    assert.ok(angleBetween(fromAngles(toAngles(turn)), turn) < 1e-6, `${angles}`);
  }
});
