// What a picture of the jaws costs where the processor draws: CPU time of Chromium's graphics process and of the page's, at
// 1440 x 900, watching and dragging; and how long it takes from a movement of the mouse to the picture that shows it. Told,
// never asserted: only THIGMA_FULL. THIGMA_STEP fixes the step of the pace.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { loadavg } from "node:os";
import { test } from "node:test";
import { openPage, startBrowser } from "../browser/browser.mjs";
import { startProgram } from "../program.mjs";
import { cpuOf } from "./cpu.mjs";

const program = process.env.THIGMA_PROGRAM;
const SECONDS = Number(process.env.THIGMA_SECONDS ?? 15), STEP = process.env.THIGMA_STEP;
/// Notes in the page where the hand is after each movement of the mouse, and where each picture shows it once it is done.
function startTrace() {
  const { hand, session, stage } = window.thigma, trace = { moves: [], pictures: [] };
  addEventListener("pointermove", ({ timeStamp }) => trace.moves.push({ at: timeStamp, hand: [...hand.position] }));
  let seen = window.thigma.drawn, waiting = null;
  setInterval(() => {
    if (waiting && !stage.fence) { trace.pictures.push({ ...waiting, at: performance.now() }); waiting = null; }
    if (window.thigma.drawn === seen) return;
    seen = window.thigma.drawn;
    waiting = { shown: [...session.shown.handle.position] };
    if (!stage.fence) { trace.pictures.push({ ...waiting, at: performance.now() }); waiting = null; }
  }, 1);
  return trace;
}

/// Of one sweep in one direction: after each movement the time until a picture shows the hand as far as it led, less half a
/// step [ms].
function delays({ moves, pictures }) {
  const way = (from, to) => from.map((value, k) => to[k] - value), dot = (a, b) => a.reduce((sum, value, k) => sum + value * b[k], 0);
  const dragged = way(moves[0].hand, moves.at(-1).hand), shown = way(pictures[0].shown, pictures.at(-1).shown);
  const share = (from, to, whole) => dot(way(from, to), whole) / dot(whole, whole), half = 0.5 / (moves.length - 1);
  return moves.slice(1).map(({ at, hand }) => {
    const reached = share(moves[0].hand, hand, dragged) - half;
    return pictures.find((one) => one.at > at && share(pictures[0].shown, one.shown, shown) >= reached).at - at;
  });
}

async function inputToPicture(page, x, y) {
  const trace = await page.evaluateHandle(startTrace), all = [];
  for (let sweep = 0; sweep < 8; sweep++) {
    await new Promise((resolve) => setTimeout(resolve, 1500)); // until the hand is shown at rest
    await page.evaluate((one) => { one.moves.length = 0; one.pictures.splice(0, one.pictures.length - 1); }, trace);
    for (let k = 0; k <= 40; k++) {
      await page.mouse.move(x + 3 * (sweep % 2 ? 40 - k : k), y);
      await new Promise((resolve) => setTimeout(resolve, 16));
    }
    await new Promise((resolve) => setTimeout(resolve, 1500));
    all.push(...delays(await trace.jsonValue()));
  }
  return all.sort((a, b) => a - b);
}

test("what a picture costs", { timeout: 900000 }, async (t) => {
  if (!process.env.THIGMA_FULL) { t.skip("takes minutes: THIGMA_FULL is not set"); return; }
  if (!program || !existsSync(program)) { t.skip("no program to run (THIGMA_PROGRAM is not set or not there)"); return; }
  const { browser, reason } = await startBrowser();
  if (!browser) { t.skip(reason); return; }
  const run = await startProgram(program, ["SCENES/jaws.toml", "--device", "web:"]);
  const { page, errors } = await openPage(browser, run.address, { viewport: { width: 1440, height: 900 } });
  try {
    await page.waitForFunction(() => window.thigma?.session.counts.snapshot > 5 && window.thigma.drawn > 3);
    if (STEP !== undefined) await page.evaluate((step) => Object.assign(window.thigma.stage, { resized: true }).pace = { ...window.thigma.stage.pace, step, fixed: true }, Number(STEP));
    const box = await page.locator("#scene").boundingBox(), x = box.x + box.width / 2, y = box.y + box.height / 2;
    for (const what of ["watching", "dragging"]) {
      if (what === "dragging") { await page.mouse.move(x, y); await page.mouse.down(); }
      await new Promise((resolve) => setTimeout(resolve, 4000));
      const before = { drawn: await page.evaluate(() => window.thigma.drawn), gpu: cpuOf("gpu-process"), page: cpuOf("renderer"), at: Date.now() };
      for (let k = 0; Date.now() - before.at < 1000 * SECONDS; k++) {
        if (what === "dragging") await page.mouse.move(x + 80 * Math.sin(0.2 * k), y + 60 * Math.sin(0.1 * k));
        else await page.evaluate(() => { window.thigma.stage.dirty = true; });
        await new Promise((resolve) => setTimeout(resolve, 30));
      }
      const drawn = (await page.evaluate(() => window.thigma.drawn)) - before.drawn, seconds = (Date.now() - before.at) / 1000;
      assert.ok(drawn > 0);
      const info = await page.evaluate(() => { const { stage } = window.thigma, { render } = stage.renderer.info;
        return { step: stage.pace.step, triangles: render.triangles, calls: render.calls, ghost: stage.ghost.group.visible,
          vertices: [stage.object, ...stage.statics].map((body) => body.geometry.attributes.position.count), canvas: [stage.canvas.width, stage.canvas.height] }; });
      const cost = (kind, name) => ((1000 * (cpuOf(kind) - before[name])) / drawn).toFixed(0);
      console.log(`${what}: ${drawn} pictures in ${seconds.toFixed(0)} s (${(drawn / seconds).toFixed(1)} a second) at a load of ${loadavg()[0].toFixed(1)}; a picture takes ` +
        `${cost("gpu-process", "gpu")} ms CPU of the graphics process, ${cost("renderer", "page")} ms of the page; ${JSON.stringify(info)}`);
    }
    const late = await inputToPicture(page, x, y), of = (share) => late[Math.min(late.length - 1, Math.floor(share * late.length))].toFixed(0);
    assert.ok(late.length > 200 && late.every((ms) => ms > 0));
    console.log(`input to picture: p50 ${of(0.5)} ms, p90 ${of(0.9)} ms, max ${of(1)} ms of ${late.length} movements, at a load of ${loadavg()[0].toFixed(1)}`);
    await page.mouse.up();
    assert.deepEqual(errors, []);
  } finally {
    await browser.close();
    await run.end();
  }
});
