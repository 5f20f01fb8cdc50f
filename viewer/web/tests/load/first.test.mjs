// Every scene of the program, chosen in the page with an empty cache: how long until the canvas shows it, and the processor's
// time for that: of the program's new threads until the scene comes, of the page from then on. Told, never asserted, as the machine may have other work: only THIGMA_FULL.
// THIGMA_SCENE names one alone.
import assert from "node:assert/strict";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { loadavg, tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { openPage, startBrowser } from "../browser/browser.mjs";
import { startProgram } from "../program.mjs";
import { cpuOf, followNewThreads } from "./cpu.mjs";

const program = process.env.THIGMA_PROGRAM, only = process.env.THIGMA_SCENE;

/// Waits in the page for the first picture of a scene after another; when it was done, and when the scene had come [ms of the page].
function firstPicture(name) {
  return new Promise((resolve) => {
    const { session } = window.thigma;
    let told = null, drawn = null;
    const timer = setInterval(() => {
      const { stage } = window.thigma, here = session.scene?.name === name && session.state?.scene !== null && session.shown !== null;
      if (session.scene?.name === name) told ??= performance.now();
      if (!here) { drawn = null; return; }
      drawn ??= window.thigma.drawn;
      if (window.thigma.drawn <= drawn || stage.fence) return;
      clearInterval(timer);
      resolve({ told, at: performance.now() });
    }, 5);
  });
}

test("every scene of the program shows its first picture with an empty cache", { timeout: 1800000 }, async (t) => {
  if (!process.env.THIGMA_FULL) { t.skip("takes minutes: THIGMA_FULL is not set"); return; }
  if (!program || !existsSync(program)) { t.skip("no program to run (THIGMA_PROGRAM is not set or not there)"); return; }
  const { browser, reason } = await startBrowser();
  if (!browser) { t.skip(reason); return; }
  const scenes = Object.keys((await import("../../src/scenefacts.js")).SCENE_FACTS);
  assert.ok(scenes.length > 10);
  try {
    for (const name of only ? [only] : scenes) await chooseOne(browser, name);
  } finally {
    await browser.close();
  }
});

/// From two boxes, as a scene that runs already could not be seen to come.
async function chooseOne(browser, name) {
  const cache = mkdtempSync(join(tmpdir(), "thigma-cache-"));
  const run = await startProgram(program, ["--object", "procedural:box", "--against", "procedural:box", "--device", "web:"], { XDG_CACHE_HOME: cache });
  const { page, errors, context } = await openPage(browser, run.address, { viewport: { width: 1440, height: 900 } });
  try {
    await page.waitForFunction(() => window.thigma?.session.shown && window.thigma.drawn > 3);
    await page.getByRole("button", { name: "Open a scene" }).click();
    const waits = page.evaluate(firstPicture, name), loading = followNewThreads(run.child.pid);
    const chosen = await page.evaluate((one) => {
      const buttons = [...document.querySelectorAll("#opener .open-list .open-item")], { scenes } = window.thigma.opener.menu;
      buttons[scenes.findIndex((scene) => scene.name === one)].click();
      return performance.now();
    }, name);
    await page.waitForFunction((one) => window.thigma.session.scene?.name === one, name);
    const loaded = loading(), before = cpuOf("renderer"), { told, at } = await waits, shown = cpuOf("renderer") - before;
    const seen = await page.evaluate(() => { const { stage, session } = window.thigma;
      return { triangles: [stage.object, ...stage.statics].map(({ about }) => about.triangles), title: session.scene.title }; });
    assert.ok(at > chosen && told > chosen);
    assert.deepEqual(errors, []);
    console.log(`${name}: first picture after ${(at - chosen).toFixed(0)} ms (the scene after ${(told - chosen).toFixed(0)}, ` +
      `${loaded.filter((s) => s > 0.05).map((s) => s.toFixed(1)).join(" + ")} s CPU of its threads, then ${shown.toFixed(1)} s of the page), ${seen.triangles.join(" + ")} triangles, load ${loadavg()[0].toFixed(1)}`);
  } finally {
    await context.close();
    await run.end();
    rmSync(cache, { recursive: true, force: true });
  }
}
