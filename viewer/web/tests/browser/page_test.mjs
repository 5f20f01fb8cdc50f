// A test of the page in Chromium against the stand-in server: what it shows, what it sends. Never how fast.
//   node --test tests/browser        THIGMA_SHOTS=DIR keeps the screenshots
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { startMock } from "../mock/server.mjs";
import { openPage, startBrowser } from "./browser.mjs";

const PATIENCE = { timeout: 400000 }; // software rendering on a busy machine
let browser = null, reason = null;

before(async () => {
  ({ browser, reason } = await startBrowser());
});
after(async () => { await browser?.close(); });

/// A test with a page of its own on a server of its own; fails on any error the page reports.
export function pageTest(name, options, body) {
  test(name, PATIENCE, async (t) => {
    if (reason) { t.skip(reason); return; }
    if (!browser.isConnected()) ({ browser } = await startBrowser()); // one that died fails its own test only
    const mock = await startMock({ device: options.device ?? "web:", constrained: options.constrained ?? false });
    const { page, errors, context } = await openPage(browser, "about:blank", options.context);
    page.setDefaultTimeout(150000);
    const hosts = new Set(); // that anything came from
    page.on("request", (request) => hosts.add(new URL(request.url()).host));
    try {
      if (options.prepare) await page.addInitScript(options.prepare);
      await page.goto(`http://127.0.0.1:${mock.port}/${options.query ?? ""}`);
      await page.waitForFunction(() => window.thigma?.session.counts.snapshot > 5 && window.thigma.session.counts.mesh === 2);
      await body({ mock, page, errors, hosts });
      assert.deepEqual(errors.filter((text) => !(options.mayReport ?? /^$/).test(text)), []);
    } finally {
      await context.close();
      mock.close();
    }
  });
}

export const drawnSince = async (page, n = 2) => {
  const from = await page.evaluate(() => window.thigma.drawn);
  await page.waitForFunction(([since, more]) => window.thigma.drawn >= since + more, [from, n]);
};

export async function drag(page, dx, dy, steps = 12) {
  const box = await page.locator("#scene").boundingBox();
  const x = box.x + box.width / 2, y = box.y + box.height / 2;
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.waitForFunction(() => window.thigma.session.holding && window.thigma.hand.clutch);
  for (let k = 1; k <= steps; k++) await page.mouse.move(x + (dx * k) / steps, y + (dy * k) / steps);
  await page.mouse.up();
}
