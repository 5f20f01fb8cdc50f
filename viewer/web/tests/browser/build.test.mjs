// A scene put together on the page in Chromium, against the stand-in server.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { startMock } from "../mock/server.mjs";
import { openPage, startBrowser, until } from "./browser.mjs";

const PATIENCE = { timeout: 400000 };
let browser = null, reason = null;
before(async () => { ({ browser, reason } = await startBrowser()); });
after(async () => { await browser?.close(); });

function buildTest(name, body) {
  test(name, PATIENCE, async (t) => {
    if (reason) { t.skip(reason); return; }
    const mock = await startMock({ device: "hand:" });
    const { page, errors, context } = await openPage(browser, "about:blank");
    page.setDefaultTimeout(150000);
    try {
      await page.goto(`http://127.0.0.1:${mock.port}/`);
      await page.waitForFunction(() => window.thigma?.session.counts.snapshot > 5 && window.thigma.session.counts.mesh === 2 && window.thigma.drawn > 0);
      await page.getByRole("tab", { name: "Scene" }).click();
      await body({ mock, page });
      assert.deepEqual(errors, []);
    } finally {
      await context.close();
      mock.close();
    }
  });
}

/// Objects as the program has them, once it has them as they should be.
async function composed(mock, holds, what) {
  await until(() => mock.composed && holds(mock.composed.objects), what);
  return mock.composed.objects;
}
const settled = (page) => page.waitForFunction(() => !window.thigma.builder.busy && window.thigma.session.counts.mesh % 2 === 0);
const drop = async (page, names) => {
  const dropped = await page.evaluateHandle((all) => { const data = new DataTransfer(); for (const one of all) data.items.add(new File(["x"], one)); return data; }, names);
  await page.dispatchEvent("#scene", "drop", { dataTransfer: dropped });
};

buildTest("numbers, materials, mass and names change the scene, step by step, and back", async ({ page, mock }) => {
  await page.getByRole("option", { name: /lower block/ }).click();
  const set = async (label, value) => {
    const field = page.getByLabel(label, { exact: true });
    await field.fill(value);
    await field.press("Enter");
  };
  await set("position x, mm", "12.5");
  await composed(mock, (o) => Math.abs(o[1].position[0] - 0.0125) < 1e-9, "moved by numbers");
  await settled(page);
  await set("turned about z, degrees", "90");
  await composed(mock, (o) => Math.abs(o[1].quat_xyzw[2] - Math.SQRT1_2) < 1e-9, "turned by numbers");
  await settled(page);
  await set("friction", "0.4");
  await composed(mock, (o) => o[1].friction === 0.4, "friction");
  await settled(page);
  await page.getByRole("option", { name: /upper block/ }).click();
  await set("density, kg/m³", "1200");
  await composed(mock, (o) => o[0].density === 1200 && o[0].mass === null, "density");
  await settled(page);
  await set("mass, g", "25");
  await composed(mock, (o) => o[0].mass === 0.025 && o[0].density === null, "mass");
  await settled(page);
  await set("friction", "-1");
  await page.getByRole("alert").getByText("friction is wrong, expected 0 to 10").waitFor();
  assert.equal(await page.getByLabel("friction", { exact: true }).inputValue(), "", "as it was");
  await set("position x, mm", "left");
  await page.getByText('"left" is not a number.').waitFor();
  await page.locator("#scene").focus();
  await page.keyboard.press("Control+z");
  await composed(mock, (o) => o[0].density === 1200, "one step back");
  await settled(page);
  await page.getByRole("button", { name: "Undo" }).click();
  await composed(mock, (o) => o[0].density === null, "two steps back");
  await settled(page);
  await page.getByRole("button", { name: "Redo" }).click();
  await composed(mock, (o) => o[0].density === 1200, "and forth");
  await settled(page);
  await page.getByRole("option", { name: /lower block/ }).click();
  await page.getByRole("button", { name: "Take it in the hand" }).click();
  await composed(mock, (o) => o[0].name === "lower block", "the other in the hand");
  await settled(page);
  await page.getByRole("button", { name: "Remove" }).click();
  await composed(mock, (o) => o.length === 1, "removed");
  await settled(page);
  assert.ok(await page.getByRole("button", { name: "Remove" }).isDisabled(), "one is left");
});

buildTest("handles in the picture drag an object along an axis and turn it by a ring, and the view stays", async ({ page, mock }) => {
  await page.waitForFunction(() => window.thigma.gizmo?.index === 0);
  const still = await page.evaluate(() => ({ azimuth: window.thigma.stage.view.azimuth, at: window.thigma.stage.object.group.position.toArray() }));
  await page.waitForFunction((n) => window.thigma.session.counts.snapshot > n + 30, await page.evaluate(() => window.thigma.session.counts.snapshot));
  assert.deepEqual(await page.evaluate(() => window.thigma.stage.object.group.position.toArray()), still.at, "the hand of the session moves nothing here");
  for (const [mode, handle] of [["Move", "Z"], ["Turn", "Z"]]) {
    await page.getByRole("button", { name: mode, exact: true }).click();
    await page.waitForFunction((word) => window.thigma.gizmo.controls.mode === word, mode === "Move" ? "translate" : "rotate");
    const before = await page.evaluate(() => ({ at: window.thigma.stage.object.group.position.toArray(), turn: window.thigma.stage.object.group.quaternion.toArray() }));
    const find = () => page.evaluate((axis) => { // a point of the picture that is on that handle alone
      const { stage, gizmo } = window.thigma, box = stage.canvas.getBoundingClientRect(), p = stage.object.group.getWorldPosition(stage.view.target.clone()).project(stage.view.camera);
      const x = box.left + ((p.x + 1) / 2) * box.width, y = box.top + ((1 - p.y) / 2) * box.height;
      for (let r = 20; r < 240; r += 4) for (let angle = 0; angle < 6.28; angle += 0.05) {
        const at = { x: x + r * Math.cos(angle), y: y + r * Math.sin(angle) };
        gizmo.controls.pointerHover({ x: ((at.x - box.left) / box.width) * 2 - 1, y: 1 - ((at.y - box.top) / box.height) * 2, button: 0 });
        if (gizmo.controls.axis === axis && document.elementFromPoint(at.x, at.y) === stage.canvas) return at;
      }
      return null;
    }, handle);
    // Where it still is a little later: the picture may be about to follow the scene.
    let spot = null;
    for (let tries = 0, last = null; tries < 50 && !spot; tries++) {
      const next = await find();
      if (next && last && Math.hypot(next.x - last.x, next.y - last.y) < 0.5) spot = next;
      last = next;
      await page.waitForTimeout(150);
    }
    assert.ok(spot, `${mode}: a place to take it`);
    mock.composed = null;
    await page.mouse.move(spot.x, spot.y);
    await page.mouse.down();
    await page.mouse.move(spot.x + 25, spot.y - 40, { steps: 6 });
    await page.mouse.up();
    const [held] = await composed(mock, () => true, `${mode} is told`);
    if (mode === "Move") {
      assert.ok(held.position[2] > before.at[2] + 0.001, "up");
      [0, 1].forEach((k) => assert.ok(Math.abs(held.position[k] - before.at[k]) < 1e-9, "along its axis alone"));
    } else {
      assert.ok(Math.abs(held.quat_xyzw[2]) > 0.02 && Math.hypot(held.quat_xyzw[0], held.quat_xyzw[1]) < 1e-6, `about z: ${held.quat_xyzw}`);
    }
    await settled(page);
    await page.waitForFunction(() => window.thigma.gizmo.index === 0);
  }
  assert.equal(await page.evaluate(() => window.thigma.stage.view.azimuth), still.azimuth);
  await page.getByRole("tab", { name: "Plots" }).click();
  await page.waitForFunction(() => window.thigma.gizmo.index === null && !window.thigma.stage.editing);
  await page.waitForFunction(() => { const { stage } = window.thigma; return stage.last && stage.object.group.position.z === stage.last.object.position[2]; });
});

buildTest("several meshes are dropped at once, one by one with its unit; the scene is saved", async ({ page, mock }) => {
  await drop(page, ["skull.stl", "jaw.ply"]);
  let objects = await composed(mock, (o) => o.length === 4, "two more");
  assert.deepEqual(objects.slice(2).map(({ source, name, unit }) => [source, name, unit]), [["file:1", "skull", 0.001], ["file:2", "jaw", 0.001]]);
  assert.ok(objects[3].position[0] > objects[2].position[0], "side by side");
  await settled(page);
  await drop(page, ["one.obj"]);
  await page.getByText("Needs repair first").waitFor();
  await page.getByLabel("Its unit is").selectOption({ label: "centimetres (400 mm)" });
  await page.getByRole("button", { name: "Add it to the scene" }).click();
  objects = await composed(mock, (o) => o.length === 5, "one more");
  assert.deepEqual([objects[4].source, objects[4].unit], ["file:3", 0.01]);
  await settled(page);
  await drop(page, ["fine.stl", "bad.obj"]);
  await page.getByText("Cannot be used").waitFor();
  await page.keyboard.press("Escape");
  assert.equal(mock.composed.objects.length, 5, "nothing is added with one that is rejected");
  const name = page.getByLabel("Name to save it under");
  await name.fill("my scans");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.getByText("Saved: /home/me/scenes/my scans.toml").waitFor();
  await page.getByRole("button", { name: "Save as one file" }).click();
  await page.getByText("Saved: /home/me/scenes/my scans.mcap").waitFor();
  await name.fill("../evil");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.getByText("'../evil' is no name for a scene").waitFor();
});

buildTest("the tab fits and passes an audit at three sizes, light and dark", async ({ page }) => {
  await page.evaluate(readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8"));
  const found = new Set();
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    for (const [width, height] of [[1440, 900], [1024, 768], [390, 844]]) {
      await page.setViewportSize({ width, height });
      await page.waitForTimeout(200);
      const wide = await page.evaluate(() => [...document.querySelectorAll("body *:not(.name-tags *)")].filter((one) => one.getBoundingClientRect().right > innerWidth + 1).length);
      if (wide > 0) found.add(`${colorScheme} ${width}: ${wide} do not fit`);
      const { violations } = await page.evaluate(() => window.axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "best-practice"] }));
      for (const { id, nodes } of violations) found.add(`${colorScheme} ${width}: ${id} at ${nodes[0].target}: ${nodes[0].failureSummary}`);
      if (process.env.THIGMA_SHOTS) await page.screenshot({ path: `${process.env.THIGMA_SHOTS}/build-${colorScheme}-${width}.png` });
    }
  }
  assert.deepEqual([...found], []);
});
