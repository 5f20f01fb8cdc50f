import assert from "node:assert/strict";
import { test } from "node:test";
import { guideLine, makeGuide } from "../../src/guide.js";

const session = (may_control, run) => ({
  connected: true, hello: { may_control }, scene: { object: { name: "ball" }, statics: [{ name: "plate" }] },
  state: { run, reason: "stopped", device: "hand:", devices: ["hand:", "web:"], holder: null }, snapshot: { bits: 0, time: 1 },
});
const facts = { now: 1, holding: false, newtons: 0, turned: false };
const act = { device: () => {}, reset: () => {} };

test("a page without the token is told how to do more, and offered nothing", () => {
  const line = guideLine(makeGuide(), session(false, "running"), facts, act);
  assert.match(line.text, /only|watches/);
  assert.match(line.text, /token/);
  assert.equal(line.button, undefined);
  assert.equal(guideLine(makeGuide(), session(false, "ended"), facts, act).button, undefined);
});

test("a page with it is offered the hand, and to begin again", () => {
  assert.equal(guideLine(makeGuide(), session(true, "running"), facts, act).button, "Take it yourself");
  assert.equal(guideLine(makeGuide(), session(true, "ended"), facts, act).button, "Begin again");
});

test("fingers are told of fingers, a mouse of keys", () => {
  const held = { ...session(true, "running"), snapshot: { bits: 3, time: 1 } };
  held.state = { ...held.state, device: "web:", holder: "you" };
  const say = (touch, newtons) => {
    const guide = makeGuide();
    return guideLine(guide, held, { ...facts, holding: true, newtons, touch }, act).text;
  };
  for (const newtons of [0, 1]) {
    assert.match(say(true, newtons), /finger/);
    assert.doesNotMatch(say(true, newtons), /Shift|Ctrl|wheel|Space|Right-drag/);
    assert.match(say(false, newtons), /Shift|Ctrl/);
  }
});

test("in a world any body may be taken, and is let go of by letting go", () => {
  const world = { ...session(true, "running"), snapshot: { bits: 0, time: 1 } };
  world.scene = { ...world.scene, world: { bodies: 3 } };
  world.state = { ...world.state, device: "web:", holder: "none" };
  const say = (more) => guideLine(makeGuide(), world, { ...facts, ...more }, act).text;
  assert.match(say({ touch: false }), /Press on a body.*let go/);
  assert.match(say({ touch: true }), /Touch a body/);
  assert.match(say({ touch: false, holding: true }), /Shift-drag/);
  assert.match(say({ touch: true, holding: true }), /Two fingers/);
});
