// Drags while the machine is busy and the page's main thread stands still for up to a second at a time: the hand fades and
// comes back, and is never lost. What was felt is told, never asserted. THIGMA_FULL: 20 drags of 5 s on the jaws.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { existsSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { openPage, startBrowser } from "../browser/browser.mjs";
import { startProgram } from "../program.mjs";
import { openClient } from "./client.mjs";

const program = process.env.THIGMA_PROGRAM;
const FULL = Boolean(process.env.THIGMA_FULL);
const DRAGS = FULL ? 20 : 3, SECONDS = FULL ? 5 : 1.5, LOAD = 4;
const BLOCKS = [300, 600, 1000]; // of the main thread, in turn [ms]
const small = join(dirname(fileURLToPath(import.meta.url)), "../browser/small.toml");
const GRASPED = 1, FAULT = 4, FADING = 32, DEVICE_LOST = 1;

/// Programs that do nothing but take a processor, and end by themselves at the latest.
function burn(count, seconds) {
  const burners = Array.from({ length: count }, () =>
    spawn(process.execPath, ["-e", `for (const end = Date.now() + ${1000 * seconds}; Date.now() < end;);`], { stdio: "ignore" }));
  return () => burners.forEach((one) => one.kill());
}

/// What another page hears: how often the hand was lost, let go of, and how much of the time it counted less.
function watchHand() {
  const seen = { snapshots: 0, fading: 0, held: false, letGo: 0, faults: [], low: Infinity, high: -Infinity };
  seen.on = ({ text, binary }) => {
    if (text?.type === "event" && text.kind === "fault") seen.faults.push(text.detail);
    if (!binary || binary[0] !== 3) return;
    const bits = binary.readUInt16LE(2), height = binary.readFloatLE(24 + 4 * 16);
    seen.snapshots += 1;
    seen.fading += (bits & FADING) !== 0 ? 1 : 0;
    if (seen.held && !(bits & GRASPED)) seen.letGo += 1;
    seen.held = (bits & GRASPED) !== 0;
    if ((bits & FAULT) && binary.readUInt32LE(232) === DEVICE_LOST && seen.faults.length === 0) seen.faults.push("device_lost");
    seen.low = Math.min(seen.low, height);
    seen.high = Math.max(seen.high, height);
  };
  return seen;
}

/// The main thread stands still again and again, until told otherwise.
const block = (page) => page.evaluate((times) => {
  let turn = 0;
  window.blocking = true;
  window.blocked = 0;
  const stand = () => {
    if (!window.blocking) return;
    for (const end = performance.now() + times[turn++ % times.length]; performance.now() < end;);
    window.blocked += 1;
    setTimeout(stand, 200);
  };
  setTimeout(stand, 0);
}, BLOCKS);

async function dragFor(page, seconds, x, y) {
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.waitForFunction(() => window.thigma.session.holding && window.thigma.hand.clutch);
  const begin = Date.now();
  for (let t = 0; t < seconds; t = (Date.now() - begin) / 1000) {
    await page.mouse.move(x + 30 * Math.sin(2 * t), y + 60 * Math.sin(3 * t));
    await page.waitForTimeout(30);
  }
  await page.mouse.up();
  for (let k = 0; k < 5; k++) await page.mouse.move(x + 40 * k, y + 20 * k); // over the object, no button down
}

test(`${DRAGS} drags of ${SECONDS} s beside ${LOAD} busy programs, the page standing still: the hand is never lost`,
  { timeout: 1500000 }, async (t) => {
    if (!program || !existsSync(program)) { t.skip("no program to run (THIGMA_PROGRAM is not set or not there)"); return; }
    const { browser, reason } = await startBrowser();
    if (!browser) { t.skip(reason); return; }
    const run = await startProgram(program, [...(FULL ? ["jaws"] : [small, "--exact"]), "--device", "web:"]);
    const { page, errors } = await openPage(browser, run.address, { viewport: { width: 1440, height: 900 } });
    const seen = watchHand();
    let calm = () => {};
    try {
      await page.waitForFunction(() => window.thigma?.session.counts.snapshot > 5 && window.thigma.stage.object && window.thigma.drawn > 0,
        null, { timeout: 400000 });
      const watcher = await openClient(run.port, (message) => seen.on(message));
      const box = await page.locator("#scene").boundingBox();
      await page.mouse.move(box.x + 100, box.y + 100);
      await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2); // hovers, and takes nothing
      await page.waitForTimeout(300);
      assert.equal(watcher.states.at(-1)?.holder ?? "none", "none", "hovering takes no hand");
      calm = burn(LOAD, 600);
      let blocked = 0;
      for (let k = 0; k < DRAGS; k++) {
        if (k % 2 === 0) await block(page);
        await dragFor(page, SECONDS, box.x + box.width / 2, box.y + box.height / 2);
        blocked += await page.evaluate(() => { window.blocking = false; const { blocked: n } = window; window.blocked = 0; return n ?? 0; });
      }
      const before = seen.snapshots;
      for (const end = Date.now() + 60000; seen.snapshots < before + 5 && Date.now() < end;) await page.waitForTimeout(50);
      const { holder, run: runs } = watcher.states.at(-1);
      console.log(`${DRAGS} drags of ${SECONDS} s beside ${LOAD} busy programs, main thread blocked ${blocked} times for 0.3 to 1 s: lost ` +
        `${seen.faults.length}, let go ${seen.letGo}, faded in ${seen.fading} of ${seen.snapshots} snapshots, ` +
        `${watcher.states.at(-1).late?.count ?? 0} late frames ridden out`);
      assert.deepEqual(seen.faults, [], "no fault");
      assert.equal(seen.letGo, 0, "once taken it was never out of the hand");
      assert.ok(blocked > 0 && seen.held && holder === "other" && runs === "running", JSON.stringify({ blocked, held: seen.held, holder, runs }));
      assert.ok(seen.high - seen.low > 0.001, `the hand was moved by ${seen.high - seen.low} m`);
      assert.deepEqual(errors, []);
      watcher.close();
    } finally {
      calm();
      await browser.close();
      await run.end();
    }
  });
