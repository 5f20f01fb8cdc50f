import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import { SCENES_WITH_WORDS, whatToTry } from "../../src/scenes.js";
import { digits, duration, say, split } from "../../src/format.js";
import { acceptedFiles, atConeEdge, deciderWords, endWords, eventWords, filesToDrop, lateWords, levelCounts, limitWords, rowSituation, situation, worldSituation } from "../../src/words.js";

test("three digits and the right prefix", () => {
  const cases = [[1.3245, "N", "1.32 N"], [0.0123, "N m", "12.3 mN m"], [4.2e-5, "m", "42.0 µm"], [999.6, "Hz", "1.00 kHz"], [412, "Hz", "412 Hz"],
    [-0.5, "N", "-500 mN"], [0.99951, "N", "1.00 N"], [0, "N", "0 N"], [1e-12, "N", "0 N"]];
  for (const [value, unit, text] of cases) assert.equal(say(value, unit), text);
});

test("what is not known is not made up", () => {
  for (const value of [NaN, Infinity, null, undefined]) assert.deepEqual([split(value, "N").number, say(value, "N")], ["–", "–"]);
});

test("the smallest prefix holds", () => {
  assert.equal(say(0.0005, "N", 1e-3), "0.50 mN");
  assert.equal(say(3.4e-9, "m", 1e-9), "3.40 nm");
  assert.equal(say(0.4, "Hz", 1), "0.40 Hz");
});

test("digits and times", () => {
  assert.deepEqual([9.994, 9.996, 99.94, 99.96, 1234].map(digits), ["9.99", "10.0", "99.9", "100", "1234"]);
  assert.deepEqual([3.14, 185, NaN].map(duration), ["3.1 s", "3:05 min", "–"]);
});

test("the page offers what the program reads", () => {
  const kinds = [{ name: "OBJ", ending: ".obj" }, { name: "XYZ", ending: ".xyz" }];
  assert.equal(acceptedFiles(kinds), ".obj,.xyz,.tex,.mcap");
  assert.match(filesToDrop(kinds), /^Drop meshes \(OBJ, XYZ\), a texture/);
  assert.equal(acceptedFiles([]), "");
  assert.match(filesToDrop([]), /^Drop meshes, a texture/);
});

test("the situation in a sentence", () => {
  const facts = { object: "upper jaw", statics: ["lower jaw"], grasped: true, contacts: 0, clusters: 0, touching: false };
  assert.equal(situation(facts), "The upper jaw is in the hand and touches nothing.");
  assert.equal(situation({ ...facts, grasped: false }), "The upper jaw rests and touches nothing.");
  assert.equal(situation({ ...facts, contacts: 1, clusters: 1, touching: true }), "The upper jaw presses on the lower jaw at 1 contact in 1 cluster.");
  const off = { ...facts, contacts: 2, clusters: 1, touching: true, armed: false };
  assert.equal(situation(off), "The upper jaw touches the lower jaw at 2 contacts in 1 cluster; forces are off.");
  assert.equal(situation({ ...off, armed: true }), "The upper jaw presses on the lower jaw at 2 contacts in 1 cluster.");
  assert.equal(situation({ ...facts, contacts: 7, clusters: 2, statics: ["a", "b"] }), "The upper jaw is close to the scene: 7 contacts in 2 clusters.");
});

test("under constraints the sentence says what it rests on and what pulls", () => {
  const facts = { object: "block", statics: ["plate"], grasped: true, armed: true, rows: 0, pressing: 0, newtons: "2.10 N", stiffness: "500 N/m" };
  assert.equal(rowSituation(facts), "The block is in the hand and touches nothing.");
  assert.equal(rowSituation({ ...facts, rows: 12 }), "The block is close to the plate: 12 rows near, none presses.");
  assert.equal(rowSituation({ ...facts, rows: 12, pressing: 3 }), "The block rests on 3 rows of the plate; the hand pulls 2.10 N; coupling 500 N/m.");
  assert.equal(rowSituation({ ...facts, rows: 1, pressing: 1, stiffness: null }), "The block rests on 1 row of the plate; the hand pulls 2.10 N.");
  assert.equal(rowSituation({ ...facts, rows: 1, pressing: 1, armed: false }), "The block rests on 1 row of the plate; forces are off.");
});

test("what limits what is said by what happens", () => {
  const facts = { pressing: 2, stiffness: 500, stretch: 0.004, force: 2.0, heldBack: 0, squeezed: 0, say };
  assert.equal(limitWords(facts), "The coupling alone limits the force: 500 N/m × 4.00 mm. The surfaces do not give.");
  assert.match(limitWords({ ...facts, force: 1.2 }), /500 N\/m × 4\.00 mm would be 2\.00 N; it has levelled off/);
  assert.match(limitWords({ ...facts, heldBack: 0.2 }), /^Held back in 20 % .* move it more slowly\.$/);
  assert.match(limitWords({ ...facts, squeezed: 0.5, heldBack: 0.2 }), /^Squeezed: .* move it back/);
  assert.equal(limitWords({ ...facts, pressing: 0 }), "Nothing limits the object but the coupling.");
});

test("a row slides at the edge of its cone, and one that does not press has none", () => {
  const row = { normal: [0, 0, -1], friction: 0.5, presses: true, force: [0.5, 0, 1] };
  assert.equal(atConeEdge([row, { ...row, force: [0.3, 0, 1] }, { ...row, friction: 0, force: [0, 0, 1] }, { ...row, presses: false }]), 1);
});

test("events and levels", () => {
  assert.equal(eventWords({ kind: "fault", detail: "device_lost", text: "" }), "Fault: the hand was lost");
  assert.equal(eventWords({ kind: "held_back", detail: "contacts_too_slow", text: "move it more slowly" }), "Held back: move it more slowly");
  assert.equal(eventWords({ kind: "squeezed", detail: "", text: "move it back" }), "Squeezed: move it back");
  assert.equal(eventWords({ kind: "armed", detail: "", text: "" }), "Forces are on");
  assert.equal(deciderWords([{ decidedBy: 5 }]), "");
  assert.equal(deciderWords([{ decidedBy: 0 }, { decidedBy: 5 }, { decidedBy: 0 }, { decidedBy: 3 }]),
    "50 % by what a hand feels, 25 % by the cap on deviation");
  assert.deepEqual(levelCounts([{ objectLevel: 3 }, { objectLevel: 0 }, { objectLevel: 3 }]), [[0, 1], [3, 2]]);
});

test("the cause of a fault stands where the end is told", () => {
  const fault = { name: "watchdog", time: 2, text: "watchdog: 50.1 ms without a haptic step" };
  assert.equal(endWords({ reason: "fault", fault }), "ended by a fault: the haptic loop stood still (watchdog: 50.1 ms without a haptic step)");
  assert.equal(endWords({ reason: "fault", fault: null }), "ended by a fault");
  assert.equal(endWords({ reason: "stopped", fault: null }), "was stopped");
});

test("what was late is told for a while", () => {
  const late = { name: "watchdog", time: 2, text: "45.0 ms without a haptic step", count: 3 };
  assert.equal(lateWords(late, 3), "The computer was late (3 times so far): 45.0 ms without a haptic step.");
  assert.equal(lateWords(late, 9), null);
  assert.equal(lateWords(null, 3), null);
  assert.equal(eventWords({ kind: "late", detail: "watchdog", text: "45.0 ms" }), "Late: the haptic loop stood still; 45.0 ms");
});

test("a world says who holds what, and what rests", () => {
  const scene = { object: { name: "block 1", body: 1, moves: true }, statics: [{ name: "table", body: 0, moves: false }, { name: "block 2", body: 2, moves: true }] };
  const body = (asleep) => ({ asleep }), hand = (held, page) => ({ body: held, page });
  const say = (asleep, hands) => worldSituation(scene, { bodies: [body(false), ...asleep.map(body)], hands });
  assert.equal(say([true, true], [hand(-1, true)]), "2 bodies move freely; all of them rest.");
  assert.equal(say([false, true], [hand(1, true)]), "The mouse holds block 1. 2 bodies move freely; 1 of them rests.");
  assert.equal(say([false, false], [hand(2, false), hand(1, true)]), "A hand holds block 2, the mouse holds block 1. 2 bodies move freely; all are awake.");
  assert.match(worldSituation(scene, null), /yet/);
});

test("every scene of the program says what to try, and none that is not there", () => {
  const folder = new URL("../../../../scenes/", import.meta.url);
  const scenes = readdirSync(folder).filter((name) => name.endsWith(".toml"))
    .filter((name) => !readFileSync(new URL(name, folder), "utf8").includes("[[body]]"))  // several moving bodies have no page yet
    .map((name) => name.slice(0, -5));
  assert.deepEqual([...SCENES_WITH_WORDS].sort(), scenes.sort());
  assert.equal(whatToTry("mine.toml"), "");
});

test("where there are no clusters, as on relief, none are counted", () => {
  const facts = { object: "probe", statics: ["plate"], grasped: true, contacts: 16, clusters: 0, touching: true };
  assert.equal(situation(facts), "The probe presses on the plate at 16 contacts.");
  assert.equal(situation({ ...facts, clusters: 2 }), "The probe presses on the plate at 16 contacts in 2 clusters.");
  assert.equal(situation({ ...facts, touching: false }), "The probe is close to the plate: 16 contacts.");
});
