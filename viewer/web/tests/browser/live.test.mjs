// The page against the program itself: THIGMA_PROGRAM names it (ctest does). What the page shows is compared with what the
// engine says of itself in its snapshots.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { openPage, startBrowser } from "./browser.mjs";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../../..");
const program = process.env.THIGMA_PROGRAM;
const PATIENCE = { timeout: 400000 };
let browser = null, reason = null;

before(async () => {
  if (!program || !existsSync(program)) reason = "no program to run (THIGMA_PROGRAM is not set or not there)";
  else ({ browser, reason } = await startBrowser());
});
after(async () => { await browser?.close(); });

/// `thigma run` of a small scene with its page, in a folder of its own; {address, end(): exit status}.
async function startProgram(device) {
  const folder = mkdtempSync(join(tmpdir(), "thigma-page-"));
  const child = spawn(program, ["run", join(root, "scenes/ellipsoid.toml"), "--device", device, "--exact", "--port", "0"],
    { cwd: folder, stdio: ["ignore", "pipe", "pipe"] });
  let said = "";
  const ended = new Promise((resolve) => child.on("exit", (code, signal) => resolve(code ?? signal)));
  const address = await new Promise((resolve, reject) => {
    const hear = (data) => {
      said += data;
      const found = /http:\/\/127\.0\.0\.1:\d+(?=[\s/])/.exec(said);
      if (found) resolve(found[0]);
    };
    child.stdout.on("data", hear);
    child.stderr.on("data", hear);
    ended.then((code) => reject(new Error(`thigma run ended with ${code}: ${said.slice(-400)}`)));
  });
  return { address, child, end: async () => {
    child.kill("SIGINT");
    const code = await ended;
    rmSync(folder, { recursive: true, force: true });
    return code;
  } };
}

function liveTest(name, device, body) {
  test(name, PATIENCE, async (t) => {
    if (reason) { t.skip(reason); return; }
    const run = await startProgram(device);
    const { page, errors, context } = await openPage(browser, run.address);
    page.setDefaultTimeout(150000);
    try {
      await page.waitForFunction(() => window.thigma?.session.counts.snapshot > 5 && window.thigma.stage.object && window.thigma.drawn > 0);
      await body({ page, run, t });
      assert.deepEqual(errors, []);
    } finally {
      await context.close();
      await run.end();
    }
  });
}

const session = (page, read) => page.evaluate((text) => new Function("s", `return ${text};`)(window.thigma.session), read);

const LOST_AFTER = 200;  // ms without a sample, and the device counts as lost

/// Takes hold and drags down in the picture, seen from the side, until there is force. A page on a busy machine may be too
/// slow for the 0.2 s after which the device counts as lost: then it takes hold again, as a person would.
/// Returns false where the machine let go of it again and again: too slow to press anything.
async function pressDown(page) {
  const box = await page.locator("#scene").boundingBox();
  const x = Math.round(box.x + box.width / 2), y = Math.round(box.y + box.height / 2);
  await page.mouse.move(x, y);
  await page.mouse.down({ button: "right" });
  await page.mouse.move(x, y - 66);
  await page.mouse.up({ button: "right" });
  const reach = box.height / 2 - 5;  // of a hand in the picture; then it takes hold again, higher up
  let down = 0, held = false, hurdles = 0, steady = 0;
  for (const end = Date.now() + 150000; Date.now() < end;) {
    const begin = Date.now();
    const { holds, newtons } = await page.evaluate(() => { const { session: s, hand } = window.thigma;
      return { holds: s.holding && hand.clutch, newtons: Math.hypot(...s.snapshot.force) }; });
    steady = newtons > 0.4 ? steady + 1 : 0;  // the first touch is a bounce
    if (steady > 5) { await page.mouse.up(); return true; }
    if (held && !holds) ++hurdles;
    held = holds;
    if (!holds) {
      await page.mouse.up();
      await page.mouse.move(x, y);
      await page.mouse.down();
      down = 0;
      await page.waitForFunction(() => window.thigma.session.holding && window.thigma.hand.clutch, null, { timeout: 10000 })
        .catch(() => { ++hurdles; });
    } else if (steady > 0) {
      // hold still
    } else if (down < reach) {
      down += 2;
      await page.mouse.move(x, y + down);
      if (Date.now() - begin > LOST_AFTER) ++hurdles;
    } else {
      await page.mouse.up();
      held = false;
    }
    await page.waitForTimeout(40);
  }
  assert.ok(hurdles > 2, "held, and never pressed");
  return false;
}

/// What page and engine say while the hand presses, drawn at least twice since; null where the machine was too slow for it.
async function readPressed(page) {
  for (let attempt = 0; attempt < 3 && await pressDown(page); ++attempt) {
    const from = await page.evaluate(() => window.thigma.drawn);
    await page.waitForFunction((n) => window.thigma.drawn > n + 2, from);
    const seen = await page.evaluate(() => {
      const { stage, session: s, plots, hand } = window.thigma;
      return { drawn: stage.object.group.position.toArray(), engine: stage.last.object.position, ghost: stage.ghost.group.position.toArray(),
        arrow: stage.force.group.visible, penetration: s.snapshot.penetration, stretch: s.snapshot.stretch, tolerance: s.scene.tolerance,
        contacts: s.snapshot.contacts.length, rows: plots.rows, faults: s.snapshot.bits & 4, holds: s.holding && hand.clutch };
    });
    if (seen.holds && seen.faults === 0) return seen;
  }
  return null;
}

const TOO_SLOW = "this machine was too busy to hold the device";

liveTest("a drag moves the object until it presses, and not through", "web:", async ({ page, t }) => {
  const start = await session(page, "s.snapshot.object.position[2]");
  const seen = await readPressed(page);
  if (!seen) { t.skip(TOO_SLOW); return; }
  assert.deepEqual(seen.drawn, seen.engine, "drawn where the engine has it");
  assert.ok(seen.engine[2] < start, "it went down");
  assert.ok(seen.arrow && seen.contacts > 0 && seen.rows > 100 && seen.faults === 0, JSON.stringify(seen));
  assert.ok(seen.ghost[2] < seen.engine[2], "the ghost is below the object");
  assert.ok(seen.penetration < 0.5 * seen.stretch, "the surfaces give less than the hand");
});

liveTest("what the page asks for happens", "hand:", async ({ page }) => {
  await page.getByRole("button", { name: "Pause" }).click();
  await page.waitForFunction(() => window.thigma.session.state.run === "paused" && (window.thigma.session.snapshot.bits & 8) !== 0);
  const frame = await session(page, "s.snapshot.frame");
  await page.getByRole("button", { name: "One step" }).click();
  await page.waitForFunction((n) => window.thigma.session.snapshot.frame > n, frame);
  await page.getByRole("button", { name: "Go on" }).click();
  await page.waitForFunction(() => window.thigma.session.state.run === "running");
  await page.getByRole("tab", { name: "Parameters" }).click();
  const stiffness = page.getByLabel("coupling stiffness, N/m");
  const value = Number(await stiffness.inputValue());
  await stiffness.fill(String(0.8 * value));
  await stiffness.press("Enter");
  await page.waitForFunction((now) => window.thigma.session.parameters.some((one) => one.name === "coupling_stiffness" &&
    Math.abs(one.value - now) < 1e-6 * now), 0.8 * value);
  const number = await session(page, "s.state.session");
  await page.getByRole("button", { name: "Begin again" }).click();
  await page.waitForFunction((n) => window.thigma.session.state.session > n, number);
  await page.getByRole("button", { name: "Take it yourself" }).click();
  await page.waitForFunction(() => window.thigma.session.state.device === "web:" && window.thigma.session.state.holder === "you");
});

/// Another page of the same session that watches and draws nothing, so that it takes no processor from the one that holds.
async function openWatcher(address) {
  const watcher = await openPage(browser, "about:blank");
  await watcher.page.addInitScript(() => { window.requestAnimationFrame = () => 0; });
  await watcher.page.goto(address);
  await watcher.page.waitForFunction(() => window.thigma?.session.counts.snapshot > 5, null, { polling: 50 });
  return watcher;
}

liveTest("a page that goes leaves no force behind", "web:", async ({ page, run, t }) => {
  const watcher = await openWatcher(run.address);
  const newtons = (from) => session(from, "Math.hypot(...s.snapshot.force)");
  let isSeen = false, isSentOnly = false;
  for (let attempt = 0; attempt < 3 && !isSeen && await pressDown(page); ++attempt) {
    isSentOnly = true;  // unless the page that holds stops pressing, too
    for (const end = Date.now() + 3000; Date.now() < end && !isSeen;) {
      isSeen = await newtons(watcher.page) > 0.1;
      isSentOnly = isSentOnly && await newtons(page) > 0.1;
    }
  }
  if (!isSeen) {
    assert.ok(!isSentOnly, "one page hears of force and the other does not");
    t.skip(TOO_SLOW);
    return;
  }
  await page.goto("about:blank");
  await watcher.page.waitForFunction(() => Math.hypot(...window.thigma.session.snapshot.force) === 0, null, { polling: 50 });
  await watcher.context.close();
  await page.goto(run.address);
});
