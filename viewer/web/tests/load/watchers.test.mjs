// Three pages, one of which stops reading in the middle: frames are dropped for it and counted, and the loop goes on. How
// the haptic step does beside one and three pages is told, never asserted. THIGMA_FULL: longer.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { test } from "node:test";
import { openClient } from "./client.mjs";
import { startProgram } from "../program.mjs";

const program = process.env.THIGMA_PROGRAM;
const SECONDS = process.env.THIGMA_FULL ? 30 : 3;
const DEAF = Math.min(SECONDS + 2, 6); // a page that has been deaf for ten seconds is gone

/// Waits until `holds` does.
async function until(holds, what) {
  for (const end = Date.now() + 120000; Date.now() < end;) {
    if (holds()) return;
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  assert.fail(`never: ${what}`);
}

const median = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];
const timings = (states) => {
  const known = states.filter(({ timing }) => timing.step_cpu_us.p50 !== null);
  return Object.fromEntries(["step_cpu_us", "wake_late_us"].flatMap((name) => ["p50", "p99"].map((p) =>
    [`${name} ${p}`, median(known.map(({ timing }) => timing[name][p]))])));
};

test("three pages, one of them deaf in the middle", { timeout: 400000 }, async (t) => {
  if (!program || !existsSync(program)) { t.skip("no program to run (THIGMA_PROGRAM is not set or not there)"); return; }
  const run = await startProgram(program, ["SCENES/ellipsoid.toml", "--response", "penalty", "--device", "hand:"]);
  try {
    const first = await openClient(run.port);
    await until(() => first.states.length >= SECONDS, "states of one page");
    const alone = timings(first.states.splice(0));
    const second = await openClient(run.port), third = await openClient(run.port);
    await until(() => third.snapshots > 10, "snapshots of the third");
    third.socket.pause(); // reads nothing any more
    // Some 100 kB each, one by one, as no level is sent while more than 1 MiB waits: they fill what lies between.
    for (let id = 1; id <= 120; id++) {
      third.send({ type: "level", id, mesh: 1, value: 1 });
      await new Promise((resolve) => setTimeout(resolve, 15));
    }
    const before = first.snapshots;
    await until(() => first.states.length >= DEAF && second.states.length >= DEAF - 2, "states of the others");
    await until(() => first.snapshots - before > 5 && second.snapshots > 5, "further snapshots of the others");
    const last = first.states.at(-1);
    assert.equal(last.run, "running");
    assert.equal(last.pages, 3);
    third.socket.resume();
    const heard = third.states.length;
    await until(() => third.states.length > heard + 3 && third.states.at(-1).dropped.yours > 20, "dropped frames, counted");
    const { dropped } = third.states.at(-1);
    await until(() => first.states.length >= SECONDS + 2, "states of the first beside the others");
    const watched = timings(first.states);
    t.diagnostic(`dropped for the deaf page ${dropped.yours}, for the others ${first.states.at(-1).dropped.yours}, ` +
      `${second.states.at(-1).dropped.yours}; rows left out ${dropped.rows}`);
    for (const [name, value] of Object.entries(alone)) {
      console.log(`${name}: ${value.toFixed(2)} us beside one page, ${watched[name].toFixed(2)} beside three, ratio ${(watched[name] / value).toFixed(2)}`);
    }
    console.log(`dropped for the deaf page: ${dropped.yours}`);
    for (const one of [first, second, third]) one.close();
  } finally {
    await run.end();
  }
});
