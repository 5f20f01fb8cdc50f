import assert from "node:assert/strict";
import { test } from "node:test";
import { clearHistory, makeHistory, push, toCsv, view } from "../../src/history.js";
import { fromSlider, short, toSlider } from "../../src/panels.js";

test("a spike of one sample survives, with its sign", () => {
  const history = makeHistory(["f"], 10, 100); // bins of 0.1 s
  for (let k = 0; k < 1000; k++) push(history, k / 1000, { f: k === 437 ? -5 : 1 });
  const [times, f] = view(history, ["f"]);
  assert.equal(times.length, 10);
  assert.equal(f[4], -5);
  assert.equal(f.filter((value) => value === 1).length, 9);
});

test("memory is bounded and the newest stays", () => {
  const history = makeHistory(["f"], 1, 100);
  for (let k = 0; k < 5000; k++) push(history, k / 100, { f: k });
  const [times, f] = view(history, ["f"]);
  assert.ok(times.length <= 100 && times.length > 80);
  assert.equal(f[f.length - 1], 4999);
  for (let k = 1; k < times.length; k++) assert.ok(times[k] > times[k - 1]);
});

test("gaps are gaps", () => {
  const history = makeHistory(["f", "g"], 1, 100);
  push(history, 0, { f: NaN, g: 1 });
  push(history, 0.02, { f: 2 });
  assert.deepEqual(view(history, ["f", "g"]).slice(1), [[null, 2], [1, null]]);
  assert.equal(toCsv(history, { f: "f [N]", g: "g [m]" }), "time [s],f [N],g [m]\n0.0000,,1\n0.0200,2,\n");
});

test("a session that begins again begins the plots again", () => {
  const history = makeHistory(["f"], 1, 100);
  push(history, 3, { f: 1 });
  push(history, 0.5, { f: 2 });
  assert.deepEqual(view(history, ["f"]).map((row) => [...row]), [[0.5], [2]]);
  clearHistory(history);
  assert.equal(view(history, ["f"])[0].length, 0);
});

test("sliders go there and back", () => {
  for (const scale of ["log", "linear"]) {
    const parameter = { min: 0.001, max: 20, scale };
    for (const value of [0.001, 0.02, 3, 20]) assert.ok(Math.abs(fromSlider(parameter, toSlider(parameter, value)) - value) < 1e-9);
    assert.equal(toSlider(parameter, 0.0001), 0);
    assert.equal(toSlider(parameter, 100), 1);
  }
  assert.deepEqual([0.000123456, 500, 0.025].map(short), ["0.000123", "500", "0.025"]);
});
