// Scripted dragging for ten minutes (THIGMA_MINUTES): memory of server and page stay flat; how long an answer of the program
// takes is told, at the beginning and at the end. Only with THIGMA_FULL.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { test } from "node:test";
import { openPage, startBrowser } from "../browser/browser.mjs";
import { startProgram } from "../program.mjs";

const program = process.env.THIGMA_PROGRAM;
const MINUTES = Number(process.env.THIGMA_MINUTES ?? 10);
const GROWTH = 1.25; // of the last third over the first, after a warm-up

const median = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];
const thirds = (list) => [median(list.slice(0, Math.ceil(list.length / 3))), median(list.slice(-Math.ceil(list.length / 3)))];

test("dragging on and on: memory stays flat", { timeout: (MINUTES + 10) * 60000 }, async (t) => {
  if (!process.env.THIGMA_FULL) { t.skip("takes minutes: THIGMA_FULL is not set"); return; }
  if (!program || !existsSync(program)) { t.skip("no program to run (THIGMA_PROGRAM is not set or not there)"); return; }
  const { browser, reason } = await startBrowser();
  if (!browser) { t.skip(reason); return; }
  const run = await startProgram(program, ["SCENES/ellipsoid.toml", "--device", "web:"]);
  const { page, errors } = await openPage(browser, run.address);
  const cdp = await page.context().newCDPSession(page);
  try {
    await page.waitForFunction(() => window.thigma?.session.counts.snapshot > 5 && window.thigma.drawn > 0);
    const box = await page.locator("#scene").boundingBox();
    const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    const heap = async () => {
      await cdp.send("HeapProfiler.collectGarbage");
      return (await cdp.send("Runtime.getHeapUsage")).usedSize;
    };
    // The answer to a request that changes nothing: a step is refused while the session runs.
    const answer = () => page.evaluate(async () => {
      const { ask } = window.thigma, begin = performance.now();
      await ask({ type: "step", value: 1 });
      return performance.now() - begin;
    });
    const server = [], client = [], answers = [];
    const begin = Date.now(), warm = begin + Math.min(60000, MINUTES * 20000), end = warm + MINUTES * 60000;
    for (let round = 0; Date.now() < end; round++) {
      await page.mouse.move(middle.x, middle.y);
      await page.mouse.down();
      for (let k = 0; k <= 60; k++) {
        const turn = (2 * Math.PI * k) / 60;
        await page.mouse.move(middle.x + 60 * Math.sin(turn), middle.y + 90 * Math.sin(0.5 * turn));
        if (k % 10 === 0) answers.push(await answer());
      }
      await page.mouse.up();
      if (Date.now() < warm) { answers.length = 0; continue; }
      server.push(run.memory());
      client.push(await heap());
    }
    const touched = await page.evaluate(() => window.thigma.session.counts.event);
    for (const [what, list, scale, unit] of [["server, resident", server, 2 ** 20, "MiB"], ["page, heap after collection", client, 2 ** 20, "MiB"],
      ["answer of the program", answers, 1, "ms"]]) {
      const [first, last] = thirds(list);
      console.log(`${what}: ${(first / scale).toFixed(2)} ${unit} at first, ${(last / scale).toFixed(2)} ${unit} at last (${list.length} readings)`);
      if (list !== answers) assert.ok(last <= GROWTH * first, `${what} grew from ${first} to ${last}`);
    }
    const { sent, dropped } = await page.evaluate(() => ({ sent: window.thigma.session.sent, dropped: window.thigma.session.state.dropped }));
    console.log(`${server.length} rounds in ${((Date.now() - warm) / 60000).toFixed(1)} min, ${sent} samples of the hand, ${touched} events, dropped ${JSON.stringify(dropped)}`);
    assert.ok(sent > 100 && touched > 0, "the hand took hold");
    assert.deepEqual(errors, []);
  } finally {
    await browser.close();
    await run.end();
  }
});
