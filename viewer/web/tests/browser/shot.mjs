// node tests/browser/shot.mjs ADDRESS OUT.png [light|dark] [KEYS]: the picture of a running `thigma run --device hand:` for the
// documents: waits until the object presses, pauses, presses KEYS (l: levels of detail), draws in full quality.
import { openPage, startBrowser } from "./browser.mjs";

const [address, out, scheme = "light", keys = ""] = process.argv.slice(2);
const { browser, reason } = await startBrowser();
if (!browser) { console.error(reason); process.exit(3); }
const { page, errors } = await openPage(browser, `${address}?picture=full`, { colorScheme: scheme });
page.setDefaultTimeout(600000);
await page.waitForFunction(() => window.thigma?.plots.rows > 9000 && window.thigma.stage.object);
await page.waitForFunction(() => {
  const { session, act } = window.thigma;
  if (!session.connected || session.snapshot.contacts.length < 3 || Math.hypot(...session.snapshot.force) < 0.5) return false;
  act.pause();
  return true;
}, null, { polling: 50 });
await page.waitForFunction(() => window.thigma.session.state.run === "paused");
for (const key of keys) await page.keyboard.press(key);
const drawn = await page.evaluate(() => window.thigma.drawn);
await page.waitForFunction((n) => window.thigma.drawn > n + 3, drawn);
await page.screenshot({ path: out });
await page.evaluate(() => window.thigma.act.pause());
await page.waitForFunction(() => window.thigma.session.state.run === "running");
await browser.close();
if (errors.length > 0) console.error(errors.join("\n"));
process.exit(errors.length > 0 ? 1 : 0);
