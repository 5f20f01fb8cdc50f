// What the page shows, and that everyone can use it: pictures, dialogs, keys, plots, rows.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { snapshotOf } from "../mock/world.mjs";
import { until } from "./browser.mjs";
import { drawnSince, pageTest } from "./page_test.mjs";

/// Colours of the picture: {colours, share of the background's}.
const pixels = (page) => page.evaluate(() => {
  const { renderer, scene, view } = window.thigma.stage;
  renderer.render(scene, view.camera);
  const gl = renderer.getContext(), w = gl.drawingBufferWidth, h = gl.drawingBufferHeight, data = new Uint8Array(4 * w * h);
  gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, data);
  const counts = new Map();
  for (let k = 0; k < data.length; k += 4 * 7) {
    const key = (data[k] >> 3) * 1024 + (data[k + 1] >> 3) * 32 + (data[k + 2] >> 3);
    counts.set(key, (counts.get(key) ?? 0) + 1);
  }
  return { colours: counts.size, background: Math.max(...counts.values()) / (data.length / 28) };
});

pageTest("shows both objects, light and dark, wide and narrow", { device: "hand:" }, async ({ page }) => {
  await drawnSince(page);
  const graph = await page.evaluate(() => {
    const { object, statics, root } = window.thigma.stage, { scene } = window.thigma.session;
    return { whole: [object, ...statics].every((one, k) => one.geometry.index.count / 3 === [scene.object, ...scene.statics][k].triangles),
      inRoot: [object, ...statics].every((one) => one.group.parent === root),
      title: document.getElementById("title").textContent };
  });
  assert.deepEqual(graph, { whole: true, inRoot: true, title: "Block on block (made up)" });
  const light = await pixels(page);
  // On a busy machine there were once 28, with a quarter of the picture not background.
  assert.ok(light.colours > 20 && light.background < 0.97, JSON.stringify(light));
  for (const [scheme, width, height] of [["light", 1280, 720], ["dark", 1280, 720], ["light", 390, 844], ["dark", 390, 844]]) {
    await page.emulateMedia({ colorScheme: scheme });
    await page.setViewportSize({ width, height });
    await drawnSince(page);
    const layout = await page.evaluate(() => ({ wide: document.documentElement.scrollWidth, seen: innerWidth,
      stage: document.getElementById("scene").clientWidth, panel: document.getElementById("panel").getBoundingClientRect().right,
      paper: getComputedStyle(document.body).backgroundColor }));
    assert.ok(layout.wide <= layout.seen && layout.panel <= layout.seen + 0.5, `${scheme} ${width}: ${JSON.stringify(layout)}`);
    assert.ok(layout.stage >= 0.6 * Math.min(width, 1000), "the picture has most of the room");
    const bright = /rgb\((\d+)/.exec(layout.paper)[1] > 128;
    assert.equal(bright, scheme === "light");
    if (process.env.THIGMA_SHOTS) await page.screenshot({ path: join(process.env.THIGMA_SHOTS, `page-${scheme}-${width}.png`) });
  }
});

/// What overflows the page, or an element that hides it.
const overflowing = (page) => page.evaluate(() => [...document.querySelectorAll("body *")].filter((one) => {
  const box = one.getBoundingClientRect(), style = getComputedStyle(one);
  if (box.width === 0 || box.height === 0 || style.visibility === "hidden" || one.closest(".uplot, .name-tags")) return false;
  const isCut = one.scrollWidth > one.clientWidth + 1 && style.overflowX !== "visible" && !one.matches(".title, .moment, .plot-area, .plot-title, #stage, input, select");
  return box.right > innerWidth + 1 || box.left < -1 || isCut;
}).map((one) => `${one.tagName}.${one.className}#${one.id}`));

pageTest("every tab and dialog fits and passes an audit at three sizes, light and dark", { device: "hand:" }, async ({ page }) => {
  const audit = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
  await page.evaluate(audit);
  const found = new Set();
  const look = async (place) => {
    for (const name of await overflowing(page)) found.add(`${place}: ${name} does not fit`);
    const { violations } = await page.evaluate(() => window.axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "best-practice"] }));
    for (const { id, nodes } of violations) found.add(`${place}: ${id} at ${nodes[0].target}: ${nodes[0].failureSummary}`);
    if (process.env.THIGMA_SHOTS) await page.screenshot({ path: join(process.env.THIGMA_SHOTS, `audit-${place.replaceAll(" ", "-")}.png`) });
  };
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    for (const [width, height] of [[1440, 900], [1024, 768], [390, 844]]) {
      await page.setViewportSize({ width, height });
      await drawnSince(page);
      const place = `${colorScheme} ${width}`;
      for (const name of ["Plots", "Parameters", "Levels", "Events"]) {
        await page.getByRole("tab", { name }).click();
        await page.waitForTimeout(150); // colours and sizes have settled
        await look(`${place} ${name}`);
      }
      for (const key of ["o", "?"]) {
        await page.keyboard.press(key);
        await page.locator("dialog[open]").waitFor();
        await look(`${place} dialog ${key === "o" ? "open" : "help"}`);
        await page.keyboard.press("Escape");
      }
    }
  }
  assert.deepEqual([...found], []);
});

pageTest("the keyboard alone holds, moves and turns the hand, turns the view, and chooses", {}, async ({ page, mock }) => {
  const hand = () => page.evaluate(() => ({ position: [...window.thigma.hand.position], quaternion: [...window.thigma.hand.quaternion] }));
  await page.locator("#scene").focus();
  await page.keyboard.press("5"); // from above: right in the picture is +x, up is +y
  await page.keyboard.press("Space");
  await page.waitForFunction(() => window.thigma.session.holding && window.thigma.hand.clutch);
  const hold = async (keys, until) => {
    for (const key of keys) await page.keyboard.down(key);
    await page.waitForFunction(until, await hand());
    for (const key of keys.reverse()) await page.keyboard.up(key);
  };
  await hold(["ArrowRight"], (from) => window.thigma.hand.position[0] > from.position[0] + 2e-4);
  await hold(["ArrowUp"], (from) => window.thigma.hand.position[1] > from.position[1] + 2e-4);
  await hold(["PageUp"], (from) => window.thigma.hand.position[2] < from.position[2] - 2e-4);
  await hold(["Control", "ArrowRight"], (from) => window.thigma.hand.quaternion.some((value, k) => Math.abs(value - from.quaternion[k]) > 0.02));
  const azimuth = await page.evaluate(() => window.thigma.stage.view.azimuth), held = await hand();
  await page.keyboard.down("Shift");
  await page.keyboard.down("ArrowLeft");
  await page.waitForFunction((old) => Math.abs(window.thigma.stage.view.azimuth - old) > 0.05, azimuth);
  for (const key of ["ArrowLeft", "Shift"]) await page.keyboard.up(key);
  assert.deepEqual(await hand(), held, "the view turns alone");
  await until(() => mock.received.device > 3 && mock.world.grasped, "what the keys did was sent");
  assert.deepEqual(mock.received.refused, []);
  await page.keyboard.press("Space");
  await until(() => !mock.world.grasped, "let go");
  await page.getByRole("tab", { name: "Plots" }).focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(await page.getByRole("tab", { name: "Parameters" }).getAttribute("aria-selected"), "true");
  await page.keyboard.press("3");
  assert.ok(await page.evaluate(() => { const e = window.thigma.stage.view.camera.matrixWorld.elements; return e[9] > 0.99; }), "looks from +y");
});

pageTest("picture, tiles, sentences and plots show one moment, and values where the time cursor is", { device: "hand:" }, async ({ page, mock }) => {
  await page.waitForFunction(() => window.thigma.plots.rows > 3000);
  const moments = () => page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => { const { stage, session: s, plots } = window.thigma;
    resolve({ picture: stage.last?.time, shown: s.shown?.time, plots: plots.now, newest: s.snapshot.time }); })));
  for (let k = 0; k < 5; k++) {
    const seen = await moments();
    assert.ok(seen.picture === seen.shown && seen.shown <= seen.newest && seen.plots <= seen.shown, JSON.stringify(seen));
    await page.waitForTimeout(100);
  }
  await until(() => { if (mock.world.lift > 0.001) mock.run = "paused"; return mock.run === "paused"; }, "a contact");
  await page.waitForFunction(() => (window.thigma.session.shown.bits & 8) !== 0 && window.thigma.plots.now === window.thigma.session.shown.time);
  const force = await page.evaluate(() => Math.hypot(...window.thigma.session.shown.force).toFixed(2));
  await page.waitForFunction((text) => document.querySelector(".tile.force .number").textContent === text, force);
  assert.equal(await page.locator(".tile.force .unit").textContent(), "N");
  const box = await page.locator(".plot .u-over").first().boundingBox();
  await page.mouse.move(box.x + 0.9 * box.width, box.y + 10);
  await page.waitForFunction(() => window.thigma.plots.pointed && /^At [\d.]+ s, [\d.]+ s ago/.test(document.querySelector(".moment").textContent));
  // tiles follow a few frames later
  await page.waitForFunction(() => Math.abs(Number(document.querySelector(".tile.force .number").textContent) - window.thigma.plots.pointed?.force) < 0.006);
  const read = await page.evaluate(() => { const { pointed, plots, now } = window.thigma.plots;
    return { ago: now - pointed.time, force: pointed.force, tile: Number(document.querySelector(".tile.force .number").textContent),
      keys: plots[0].keys.textContent }; });
  assert.ok(Math.abs(read.ago - 1) < 0.1 && Math.abs(read.tile - read.force) < 0.006, JSON.stringify(read));
  assert.match(read.keys, /size [\d.]+ m?Nx [\d.-]+ [mµ]?N/);
  await page.mouse.move(100, 300);
  await page.waitForFunction(() => /^The last 10 s/.test(document.querySelector(".moment").textContent));
  await page.locator("#plots").focus();
  await page.keyboard.press("ArrowLeft");
  await page.waitForFunction(() => window.thigma.plots.pointed !== null);
  await page.keyboard.press("Escape");
  await page.waitForFunction(() => window.thigma.plots.pointed === null);
});

/// What is drawn of rows, and what is said of them.
const rowsShown = (page) => page.evaluate(() => { const { stage, session: s } = window.thigma, count = (name) => stage.rows[name].count;
  return { planes: count("planes"), points: count("points"), forces: count("forces"), cones: count("cones"), dots: stage.marks.dots.count,
    rows: stage.last.rows, same: stage.last === s.snapshot, ghost: stage.ghost.group.visible, rod: stage.spring.group.visible,
    legend: document.getElementById("row-legend").hidden ? null : document.getElementById("row-legend").textContent,
    words: document.getElementById("readouts").textContent }; });

pageTest("under constraints rows, those that press and their cones are drawn and said, light and dark", { device: "hand:", constrained: true }, async ({ page, mock }) => {
  await until(() => {
    if (mock.world.lift > 0.0015 && snapshotOf(mock.world, false).rows.length === 12) mock.run = "paused";
    return mock.run === "paused";
  }, "twelve rows");
  await page.waitForFunction(() => (window.thigma.session.snapshot.bits & 8) !== 0);
  for (const [scheme, width, height] of [["light", 1280, 720], ["dark", 1280, 720], ["light", 390, 844]]) {
    await page.emulateMedia({ colorScheme: scheme });
    await page.setViewportSize({ width, height });
    await drawnSince(page, 3);
    await page.waitForFunction(() => /rests on 3 rows/.test(document.getElementById("readouts").textContent));
    const seen = await rowsShown(page);
    const edges = seen.rows.filter(({ kind }) => kind === 2).length, n = seen.rows.length;
    assert.deepEqual([seen.planes, seen.points, seen.forces, seen.cones], [n - edges, n + edges, 3, 3]);
    assert.ok(seen.dots === 0 && seen.ghost && seen.rod, "rows stand for contacts; object, hand and coupling are there");
    assert.match(seen.words, /The upper block rests on 3 rows of the lower block; the hand pulls [\d.]+ m?N; coupling 500 N\/m\./);
    assert.match(seen.words, /The coupling alone limits the force: 500 N\/m × [\d.]+ mm\. The surfaces do not give\./);
    assert.match(seen.words, /12 rows in the contact model; free for 300 µm around; 1 at the edge of its cone\./);
    assert.match(seen.legend, new RegExp(`the objectwhere the hand holds itcouplingrows near×${n - 3}rows that press×3friction cone×3`));
    const room = await page.evaluate(() => [...document.querySelectorAll(".legends > :not([hidden])")].map((one) => one.getBoundingClientRect())
      .every((box) => box.left >= 0 && box.right <= document.getElementById("stage").getBoundingClientRect().right));
    assert.ok(room, "the legend fits");
    if (process.env.THIGMA_SHOTS) await page.screenshot({ path: join(process.env.THIGMA_SHOTS, `rows-${scheme}-${width}.png`) });
  }
  await page.keyboard.press("c");
  await drawnSince(page);
  assert.deepEqual((await rowsShown(page)).planes, 0, "as contacts are, rows are switched off");
  mock.world.bits = 64;
  await page.waitForFunction(() => /Held back in 20 % of the last second/.test(document.getElementById("readouts").textContent));
  mock.event("held_back", "contacts_too_slow", "the object waits for its contacts: move it more slowly");
  await page.getByText("Held back: the object waits for its contacts").first().waitFor();
});

pageTest("without constraints there is no row and nothing is said of any", { device: "hand:" }, async ({ page }) => {
  await page.waitForFunction(() => window.thigma.session.snapshot.stretch > 0.0005 && window.thigma.stage.marks.dots.count > 0);
  const seen = await rowsShown(page);
  assert.deepEqual([seen.planes, seen.points, seen.forces, seen.cones, seen.legend], [0, 0, 0, 0, null]);
  assert.doesNotMatch(await page.evaluate(() => document.querySelector(".situation").textContent), /row/);
});

pageTest("plots and words get what is sent", { device: "hand:" }, async ({ page, mock }) => {
  await page.waitForFunction(() => window.thigma.plots.rows > 2500 && window.thigma.drawn > 3);
  const seen = await page.evaluate(() => {
    const { plots, session } = window.thigma;
    return { rows: plots.rows, channels: session.counts.channels, force: Math.max(...plots.fast.values.force.filter(Number.isFinite)),
      charts: plots.plots.map(({ chart }) => chart.data[0].length), words: document.getElementById("readouts").textContent };
  });
  assert.ok(seen.force > 0.3, `${seen.force} N`);
  assert.ok(seen.charts.length === 7 && seen.charts.every((n) => n > 10), JSON.stringify(seen.charts));
  assert.ok(seen.rows <= mock.world.frame + 16 && seen.channels > 10);
  assert.match(seen.words, /The upper block (presses on|is close to|touches) the lower block at|touches nothing/);
  assert.match(seen.words, /The loop holds 1000 Hz, 0 frames missed\./);
  assert.match(seen.words, /Contacts found [34]\d\d times a second, 1\.18 ms each; the model is 2\.10 ms old\./);
});

pageTest("parameters change, and a refusal says why", {}, async ({ page, mock }) => {
  await page.getByRole("tab", { name: "Parameters" }).click();
  const stiffness = page.getByLabel("coupling stiffness, N/m");
  await stiffness.fill("250");
  await stiffness.press("Enter");
  await until(() => mock.world.spring === 250, "the new stiffness");
  const mass = page.getByLabel("mass, kg");
  await mass.fill("0.0006");
  await mass.press("Enter");
  await page.getByText("too light for this coupling").waitFor();
  assert.equal(await mass.inputValue(), "0.01", "what holds is shown again");
  await mass.fill("heavy");
  await mass.press("Enter");
  await page.getByText('"heavy" is not a number').waitFor();
  assert.ok(await page.getByLabel("error threshold", { exact: true }).isDisabled());
  await page.getByText("While recording this stays as it is.").waitFor();
  await page.locator("#parameter-contact_stiffness").fill("1");
  await until(() => mock.parameters[0].value === 20000, "the slider at its end");
  await stiffness.fill("900");
  await stiffness.press("Enter");
  await page.getByText("Risky: 900 N/m is above 800 N/m, where the loop begins to swing.").waitFor();
  const budget = mock.parameters.find((one) => one.name === "budget_us");
  await page.getByLabel("time budget on").check();
  await until(() => budget.value > 20 && budget.value < 20000, "a budget");
  await page.getByLabel("time budget on").uncheck();
  await until(() => budget.value === 0, "no budget");
  await page.getByRole("radio", { name: "direct" }).click();
  await until(() => mock.parameters.find((one) => one.name === "response").value === 1, "the direct response");
  await page.waitForFunction(() => document.querySelector(".words [aria-checked=true]").textContent === "direct");
});

pageTest("without WebGL there is a sentence, and the numbers go on", { mayReport: /WebGL/, prepare: () => {
  const original = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function getContext(kind, ...rest) {
    return String(kind).startsWith("webgl") ? null : original.call(this, kind, ...rest);
  };
} }, async ({ page }) => {
  await page.getByText("This browser shows no WebGL 2").waitFor();
  await page.waitForFunction(() => window.thigma.plots.rows > 200 && /The upper block/.test(document.getElementById("readouts").textContent));
});
