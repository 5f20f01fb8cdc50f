// node tests/browser/docshots.mjs PROGRAM FOLDER [NAME...]: pictures of running sessions for the documents, in full quality; those of
// recordings are made by live.test.mjs with THIGMA_SHOTS.
import { join } from "node:path";
import { startProgram } from "../program.mjs";
import { openPage, startBrowser } from "./browser.mjs";

const build = (mode, chosen) => async (page) => {
  await page.getByRole("tab", { name: "Scene" }).click();
  if (chosen) await page.getByRole("option", { name: chosen }).click();
  await page.getByRole("button", { name: mode, exact: true }).click();
};
/// Where the hand presses, paused.
const pressed = async (page) => {
  await page.waitForFunction(() => {
    const { session, act } = window.thigma;
    if (Math.hypot(...session.snapshot.force) < 0.5 || session.snapshot.stretch < 5e-4) return false;
    act.pause();
    return true;
  });
  await page.waitForFunction(() => window.thigma.session.state.run === "paused");
};
const PICTURES = [
  { name: "live-relief", scene: "plate", viewport: { width: 1440, height: 900 }, scheme: "light", prepare: pressed },
  { name: "live-phone", scene: "jaws", viewport: { width: 390, height: 844 }, scheme: "dark", prepare: pressed },
  { name: "live-build", scene: "jaws", viewport: { width: 1280, height: 860 }, scheme: "light", prepare: build("Move") },
  { name: "live-build-dark", scene: "jaws", viewport: { width: 1280, height: 860 }, scheme: "dark", prepare: build("Turn", /^lower jaw/) },
];

const [program, folder, ...asked] = process.argv.slice(2);
const { browser, reason } = await startBrowser();
if (!browser) { console.error(reason); process.exit(3); }
for (const { name, scene, viewport, scheme, prepare } of PICTURES) {
  if (asked.length > 0 && !asked.includes(name)) continue;
  const run = await startProgram(program, [scene, "--device", "hand:?path=press"]);
  const { page, errors, context } = await openPage(browser, `${run.address}/?picture=full`, { viewport, colorScheme: scheme });
  page.setDefaultTimeout(600000);
  await page.waitForFunction(() => window.thigma?.session.counts.snapshot > 5 && window.thigma.stage?.object && window.thigma.drawn > 1);
  await prepare(page);
  const drawn = await page.evaluate(() => { window.thigma.stage.dirty = true; return window.thigma.drawn; });
  await page.waitForFunction((n) => window.thigma.drawn > n, drawn);
  await page.waitForTimeout(2500); // words and plots follow
  await page.screenshot({ path: join(folder, `${name}.png`) });
  if (errors.length > 0) console.error(errors.join("\n"));
  await context.close();
  await run.end();
  console.log(name);
}
await browser.close();
