// The page in Chromium with a headset that tests/mock/xr.mjs makes up, against the stand-in server. No headset was at hand.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { startMock } from "../mock/server.mjs";
import { installXr } from "../mock/xr.mjs";
import { openPage, startBrowser, until } from "./browser.mjs";

const PATIENCE = { timeout: 400000 };
let browser = null, reason = null;
before(async () => { ({ browser, reason } = await startBrowser()); });
after(async () => { await browser?.close(); });

function xrTest(name, { device = "web:", prepare = () => {} }, body) {
  test(name, PATIENCE, async (t) => {
    if (reason) { t.skip(reason); return; }
    const mock = await startMock({ device });
    const { page, errors, context } = await openPage(browser, "about:blank", { viewport: { width: 1000, height: 560 } });
    page.setDefaultTimeout(150000);
    try {
      await page.addInitScript(installXr);
      await page.addInitScript(prepare);
      await page.goto(`http://127.0.0.1:${mock.port}/`);
      await page.waitForFunction(() => window.thigma?.session.counts.snapshot > 5 && window.thigma.session.counts.mesh === 2 && window.thigma.drawn > 0);
      await body({ mock, page });
      assert.deepEqual(errors, []);
      assert.deepEqual(mock.received.refused, []);
    } finally {
      await context.close();
      mock.close();
    }
  });
}

async function frames(page, n = 2) {
  const from = await page.evaluate(() => window.thigma.xr.frames);
  await page.waitForFunction(([since, more]) => window.thigma.xr.frames >= since + more, [from, n]);
}
async function enter(page, name = "Enter VR") {
  await page.getByRole("button", { name }).click();
  await page.waitForFunction(() => window.thigma.xr.frames > 1);
}
const AT = { position: [0.1, -0.3, -0.4] };
const pose = (page, at, more = {}) => page.evaluate(([to, extra]) => window.headset.pose("right", to, extra), [at, more]);
const press = (page, what, isDown) => page.evaluate(([kind, down]) => window.headset.press("right", kind, down), [what, isDown]);
const hand = (page) => page.evaluate(() => ({ position: [...window.thigma.hand.position], quaternion: [...window.thigma.hand.quaternion] }));

async function takeHold(page) {
  await pose(page, AT);
  await frames(page);
  await press(page, "select", true);
  await page.waitForFunction(() => window.thigma.session.holding && window.thigma.hand.clutch);
  await frames(page);
}

xrTest("in a headset the scene stands before the eyes in stereo, and the page draws again afterwards", {}, async ({ page }) => {
  assert.equal(await page.getByRole("button", { name: "Enter AR" }).count(), 0, "nothing is offered that is not there");
  const home = await page.evaluate(() => { const { camera } = window.thigma.stage.view; return { at: camera.matrixWorld.toArray(), fov: camera.fov }; });
  await enter(page);
  assert.equal(await page.getByRole("button", { name: "Enter VR" }).getAttribute("aria-pressed"), "true");
  const { left, right } = await page.evaluate(() => window.headset.look());
  assert.ok(left.n > 500 && right.n > 500, JSON.stringify({ left, right }));
  assert.ok(left.x > right.x + 0.01 && Math.abs(left.y - right.y) < 0.02, `a near thing lies farther right for the left eye: ${left.x} ${right.x}`);
  assert.ok(Math.abs(0.5 * (left.x + right.x) - 0.5) < 0.06, "straight ahead");
  const shown = await page.evaluate(() => { // where the scene's highest point and its middle are, seen by the headset
    const { stage, xr } = window.thigma, at = (z) => xr.rig.worldToLocal(stage.view.target.clone().setComponent(2, z)).toArray();
    return { middle: at(0), top: at(1) };
  });
  shown.middle.forEach((value, k) => assert.ok(Math.abs(value - [0, -0.3, -0.55][k]) < 1e-6));
  assert.ok(Math.abs(shown.top[1] - (-0.3 + 0.22)) < 1e-6, "z is up, the scene's radius 22 cm");
  await page.evaluate(() => { window.headset.sources.left.gamepad.axes = [0, 0, 0, -1]; });
  await page.waitForFunction(() => window.thigma.xr.room.shown > 0.3);
  await page.evaluate(() => { window.headset.sources.left.gamepad.axes = [0, 0, 0, 0]; });
  await page.getByRole("button", { name: "Enter VR" }).click(); // again: leaves
  await page.waitForFunction(() => window.thigma.xr.session === null);
  const drawn = await page.evaluate(() => window.thigma.drawn);
  await page.waitForFunction((n) => window.thigma.drawn > n + 1, drawn);
  const back = await page.evaluate(() => { const { camera } = window.thigma.stage.view; return { at: camera.matrixWorld.toArray(), fov: camera.fov }; });
  home.at.forEach((value, k) => assert.ok(Math.abs(value - back.at[k]) < 1e-9));
  assert.equal(back.fov, home.fov);
});

// Seen along +y: [of the grip in the room (x right, y up, z to the person), of the hand in the world (z up)].
const SIX = [["way", [1, 0, 0], [1, 0, 0]], ["way", [0, 1, 0], [0, 0, 1]], ["way", [0, 0, 1], [0, -1, 0]],
  ["turn", [1, 0, 0], [1, 0, 0]], ["turn", [0, 1, 0], [0, 0, 1]], ["turn", [0, 0, 1], [0, -1, 0]]];

xrTest("the grip moves the hand: six poses, squeezed, and with pulses of the force", {}, async ({ page, mock }) => {
  await page.keyboard.press("4"); // looks along +y
  await page.evaluate(() => { window.thigma.stage.view.azimuth = -Math.PI / 2; });
  await enter(page);
  await takeHold(page);
  await until(() => mock.world.grasped, "held");
  const radius = await page.evaluate(() => window.thigma.stage.radius), angle = 0.2;
  for (const [kind, axis, expected] of SIX) {
    const start = await hand(page);
    const s = Math.sin(angle / 2), c = Math.cos(angle / 2);
    await pose(page, kind === "way" ? { position: AT.position.map((value, k) => value + 0.02 * axis[k]) }
      : { ...AT, quaternion: [...axis.map((value) => s * value), c] });
    await frames(page);
    const now = await hand(page);
    if (kind === "way") {
      now.position.forEach((value, k) => assert.ok(Math.abs(value - start.position[k] - 0.02 * (radius / 0.22) * expected[k]) < 1e-9, `${axis}: ${now.position}`));
    } else {
      const want = [...expected.map((value) => s * value), c], dot = want.reduce((sum, value, k) => sum + value * now.quaternion[k], 0);
      assert.ok(Math.abs(Math.abs(dot) - 1) < 1e-9, `${axis}: ${now.quaternion}`);
    }
    await pose(page, AT);
    await frames(page);
  }
  const still = await hand(page);
  await press(page, "squeeze", true);
  await frames(page);
  await pose(page, { position: [0.1, 0.2, -0.1] });
  await frames(page);
  assert.deepEqual(await hand(page), still, "free of the hand");
  await press(page, "squeeze", false);
  await frames(page);
  await pose(page, { position: [0.1, 0.14, -0.1] });
  await until(() => mock.world.lift > 0.0005, "pressed down from there");
  await page.waitForFunction(() => window.headset.pulses.length > 2 && Math.max(...window.headset.pulses) <= 1);
});

xrTest("a controller that is lost, a headset taken off and the end of the session lift the hand", {}, async ({ page, mock }) => {
  await enter(page);
  const losses = [["not tracked", () => pose(page, null)], ["only guessed", () => pose(page, AT, { emulated: true })],
    ["taken off", () => page.evaluate(() => window.headset.show("hidden"))]];
  for (const [name, lose] of losses) {
    await takeHold(page);
    await until(() => mock.world.grasped, `held before ${name}`);
    await lose();
    await until(() => !mock.world.grasped, `let go: ${name}`);
    await page.evaluate(() => window.headset.show("visible"));
    await pose(page, AT);
    await frames(page, 4);
    assert.ok(!await page.evaluate(() => window.thigma.hand.clutch), "comes back by a new press only");
    await press(page, "select", false);
    await frames(page);
  }
  await takeHold(page);
  await until(() => mock.world.grasped, "held");
  const sent = () => mock.received.newest;
  await page.evaluate(() => window.headset.stall(true));
  await new Promise((resolve) => setTimeout(resolve, 300));
  const old = sent();
  await new Promise((resolve) => setTimeout(resolve, 600));
  assert.equal(sent(), old, "without frames nobody says that the hand is still there: its pose ages, and the force fades");
  assert.ok(mock.world.grasped);
  await page.evaluate(() => window.headset.stall(false));
  await until(() => sent() > old, "goes on");
  await page.evaluate(() => window.headset.session.end());
  await until(() => !mock.world.grasped && mock.holder === null, "let go and given back");
  await page.waitForFunction(() => window.thigma.xr.session === null && !window.thigma.session.holding);
});

xrTest("a hand of the headset takes over from the simulated one; a refusal is said", { device: "hand:", prepare: () => { window.headset.modes = ["immersive-ar"]; } },
  async ({ page, mock }) => {
    await page.evaluate(() => { window.headset.refuses = true; });
    await page.getByRole("button", { name: "Enter AR" }).click();
    await page.getByText("The headset: the headset is in use").waitFor();
    await page.evaluate(() => { window.headset.refuses = false; });
    await enter(page, "Enter AR");
    const { back } = await page.evaluate(() => window.headset.look());
    assert.equal(back[3], 0, "the room shows through");
    await pose(page, AT);
    await frames(page);
    await press(page, "select", true);
    await until(() => mock.device === "web:", "the page's hand");
    await press(page, "select", false);
    await frames(page);
    await press(page, "select", true);
    await until(() => mock.world.grasped, "held");
  });
