import assert from "node:assert/strict";
import { test } from "node:test";
import { makeHand } from "../../src/hand.js";
import { bodyToChange, makeHolding } from "../../src/holding.js";

const body = (name, moves) => ({ name, moves });
const scene = { object: body("tool", true), statics: [body("table", false), body("block 1", true)] };

test("a body that nobody chose may come once more but does not go", () => {
  assert.equal(bodyToChange("remove", scene, null), null);
  assert.equal(bodyToChange("remove", scene, { name: "gone" }), null);
  assert.equal(bodyToChange("remove", scene, { name: "table" }), null);
  assert.equal(bodyToChange("add", scene, null), "tool");
  for (const type of ["add", "remove"]) assert.equal(bodyToChange(type, scene, { name: "block 1" }), "block 1");
});

/// A page whose requests are answered when the test says so.
function page() {
  const asked = [], hand = makeHand();
  const session = { connected: false, holding: true, asking: false, scene: { world: {} } };
  const holding = makeHolding({ session, hand, stage: null, link: null, xr: null, gizmo: null,
    request: (message) => new Promise((resolve) => { asked.push({ message, answer: () => resolve({ ok: true }) }); }) });
  return { asked, hand, session, player: holding.player };
}
const settled = () => new Promise((resolve) => { setTimeout(resolve, 0); });
const names = (asked) => asked.map(({ message }) => message.value);

test("a press that comes while the one before is being answered is repeated after it", async () => {
  const { asked, hand, player } = page();
  for (const name of ["a", "b", "c"]) { // the newest counts
    player.press({ name });
    player.letGo();
  }
  player.press({ name: "d" });
  assert.deepEqual(names(asked), ["a"]);
  asked[0].answer();
  await settled();
  assert.deepEqual(names(asked), ["a", "d"]);
  assert.equal(hand.clutch, false);
  player.press({ name: "d" }); // a key that repeats
  asked[1].answer();
  await settled();
  assert.deepEqual(names(asked), ["a", "d"]);
  assert.equal(hand.clutch, true);
});

test("a press that was let go before its turn came is forgotten", async () => {
  const { asked, hand, player } = page();
  player.press({ name: "a" });
  player.letGo();
  player.press({ name: "b" });
  player.letGo();
  asked[0].answer();
  await settled();
  assert.deepEqual(names(asked), ["a"]);
  assert.equal(hand.clutch, false);
});
