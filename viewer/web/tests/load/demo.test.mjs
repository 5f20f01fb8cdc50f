// The demo beside whatever else the machine does: the session it began with still runs at the end, without a fault; what
// was missed is told, never asserted. Three seconds; with THIGMA_FULL half an hour (THIGMA_MINUTES).
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { loadavg } from "node:os";
import { test } from "node:test";
import { openClient } from "./client.mjs";
import { startProgram } from "../program.mjs";

const program = process.env.THIGMA_PROGRAM;
const MINUTES = process.env.THIGMA_FULL ? Number(process.env.THIGMA_MINUTES ?? 30) : 0.05;
const LOOK = 5000; // [ms]

test("the demo goes on and on", { timeout: (MINUTES + 5) * 60000 }, async (t) => {
  if (!program || !existsSync(program)) { t.skip("no program to run (THIGMA_PROGRAM is not set or not there)"); return; }
  const run = await startProgram(program, ["SCENES/jaws.toml", "--device", "hand:", "--json"]); // as scripts/demo
  let summary = "";
  run.child.stdout.on("data", (data) => { summary += data; });
  const client = await openClient(run.port);
  const loads = [];
  try {
    while (client.states.at(-1)?.session !== 1) await new Promise((resolve) => setTimeout(resolve, 20)); // it begins
    client.states.length = 0;
    for (const end = Date.now() + MINUTES * 60000; Date.now() < end || client.states.length < 3;) {
      await new Promise((resolve) => setTimeout(resolve, Math.min(LOOK, 60000 * MINUTES)));
      loads.push(loadavg()[0]);
      for (const { run: phase, session, fault } of client.states.slice(-10)) assert.deepEqual({ phase, session, fault }, { phase: "running", session: 1, fault: null });
      if (client.states.length > 100) client.states.splice(0, 50);
    }
    const last = client.states.at(-1);
    assert.equal(last.run, "running");
    assert.ok(last.time > 0.5 * 60 * MINUTES, "its clock is that on the wall");
    client.close();
    await run.end();
    const { frames, missed } = JSON.parse(summary).haptic;
    console.log(`${last.time.toFixed(0)} s beside a load of ${Math.min(...loads).toFixed(1)} to ${Math.max(...loads).toFixed(1)}: ` +
      `${frames} frames, ${missed} missed, late and ridden out ${last.late?.count ?? 0} times, the last: ${last.late?.text ?? "none"}`);
    console.log(`late of the loop: ${JSON.stringify(JSON.parse(summary).haptic.deadlines)}`);
  } finally {
    client.close();
    if (run.child.exitCode === null) await run.end();
  }
});
