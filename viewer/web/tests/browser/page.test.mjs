// The page in Chromium against the stand-in server: what it shows, what it sends. Never how fast.
//   node --test tests/browser        THIGMA_SHOTS=DIR keeps the screenshots
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { startMock } from "../mock/server.mjs";
import { snapshotOf } from "../mock/world.mjs";
import { openPage, startBrowser, until } from "./browser.mjs";

const PATIENCE = { timeout: 400000 }; // software rendering on a busy machine
let browser = null, reason = null;

before(async () => {
  ({ browser, reason } = await startBrowser());
});
after(async () => { await browser?.close(); });

/// A test with a page of its own on a server of its own; fails on any error the page reports.
function pageTest(name, options, body) {
  test(name, PATIENCE, async (t) => {
    if (reason) { t.skip(reason); return; }
    if (!browser.isConnected()) ({ browser } = await startBrowser()); // one that died fails its own test only
    const mock = await startMock({ device: options.device ?? "web:", constrained: options.constrained ?? false });
    const { page, errors, context } = await openPage(browser, "about:blank", options.context);
    page.setDefaultTimeout(150000);
    try {
      if (options.prepare) await page.addInitScript(options.prepare);
      await page.goto(`http://127.0.0.1:${mock.port}/${options.query ?? ""}`);
      await page.waitForFunction(() => window.thigma?.session.counts.snapshot > 5 && window.thigma.session.counts.mesh === 2);
      await body({ mock, page, errors });
      assert.deepEqual(errors.filter((text) => !(options.mayReport ?? /^$/).test(text)), []);
    } finally {
      await context.close();
      mock.close();
    }
  });
}

const drawnSince = async (page, n = 2) => {
  const from = await page.evaluate(() => window.thigma.drawn);
  await page.waitForFunction(([since, more]) => window.thigma.drawn >= since + more, [from, n]);
};

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

async function drag(page, dx, dy, steps = 12) {
  const box = await page.locator("#scene").boundingBox();
  const x = box.x + box.width / 2, y = box.y + box.height / 2;
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.waitForFunction(() => window.thigma.session.holding && window.thigma.hand.clutch);
  for (let k = 1; k <= steps; k++) await page.mouse.move(x + (dx * k) / steps, y + (dy * k) / steps);
  await page.mouse.up();
}

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

pageTest("a drag moves the hand until the object touches, and not through", {}, async ({ page, mock }) => {
  assert.equal(mock.received.device, 0, "a page that holds nothing sends nothing");
  const start = [...mock.world.object];
  await page.mouse.move(300, 500); // from the side, so that down in the picture is down
  await page.mouse.down({ button: "right" });
  await page.mouse.move(300, 430);
  await page.mouse.up({ button: "right" });
  await drag(page, 0, 160, 16);
  await until(() => mock.world.lift > 0.001, "contact");
  await page.waitForFunction(() => window.thigma.session.snapshot.stretch > 0.001);
  await drawnSince(page, 3);
  const seen = await page.evaluate(() => {
    const { stage, session } = window.thigma, at = stage.object.group.position, ghost = stage.ghost.group.position;
    return { object: at.toArray(), ghost: ghost.toArray(), arrow: stage.force.group.visible, length: stage.force.group.children[0].scale.z,
      ghostSeen: stage.ghost.group.visible, dots: stage.marks.dots.count, force: Math.hypot(...session.snapshot.force),
      sent: session.sent, ...[stage.object.finest, ...stage.object.levels.values()].filter(({ solid }) => solid.visible).map((one) =>
        ({ spots: one.uniforms.spotCount.value }))[0] };
  });
  seen.object.forEach((value, k) => assert.ok(Math.abs(value - mock.world.object[k]) < 2e-4, "drawn where the engine has it"));
  assert.ok(seen.ghost[2] < seen.object[2] - 0.001 && seen.ghostSeen, "the ghost goes on, the object does not");
  assert.ok(mock.world.object[2] < start[2] && seen.object[2] > -0.0025, "down, but not through");
  assert.ok(seen.arrow && seen.length > 0 && seen.force > 0.3);
  assert.ok(seen.dots > 0 && seen.spots > 0, "contacts are marked and coloured");
  assert.deepEqual(mock.received.refused, []);
  await page.getByRole("tab", { name: "Events" }).click();
  await page.getByText("The hand took hold of the object").first().waitFor();
  assert.ok(seen.sent > 3 && mock.received.device > 3);
});

pageTest("a movement reaches the hand before the browser's next frame, and once", {}, async ({ page }) => {
  await drag(page, 20, 10, 4);
  await page.mouse.move(400, 400);
  await page.mouse.down();
  const way = await page.evaluate(() => {
    const { hand, input, stage } = window.thigma, [pointerId] = input.pointers.keys(), at = [[...hand.position]];
    const tell = (type, x) => {
      stage.canvas.dispatchEvent(new PointerEvent(type, { pointerId, clientX: x, clientY: 400, bubbles: true }));
      at.push([...hand.position]);
    };
    input.given = -Infinity;
    tell("pointerrawupdate", 440);
    input.given = performance.now() + 1000;
    tell("pointerrawupdate", 445); // sooner than anybody sends: it waits
    tell("pointermove", 445);
    tell("pointermove", 445);
    return at.slice(1).map((one, k) => Math.hypot(...one.map((value, j) => value - at[k][j])));
  });
  await page.mouse.up();
  assert.ok(way[0] > 0, "at once");
  assert.ok(way[1] === 0 && Math.abs(way[2] / way[0] - 5 / 40) < 0.01 && way[3] === 0, `${way}`);
});

pageTest("a page whose main thread stands still goes on saying where the hand was", {}, async ({ page, mock }) => {
  await drag(page, 20, 10, 4);
  await until(() => mock.world.grasped, "held");
  const before = mock.received.device, newest = [];
  const standing = page.evaluate(() => {
    for (const end = performance.now() + 3000; performance.now() < end;);
    window.stoodStill = true;
  });
  for (const end = Date.now() + 3000; Date.now() < end;) {
    newest.push(mock.received.newest);
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  await standing;
  assert.ok(mock.received.device > before + 10, `${mock.received.device - before} messages`);
  const same = newest.filter((time) => time === newest[Math.floor(newest.length / 2)]).length;
  assert.ok(same > newest.length / 2, "with the time it had");
  assert.ok(mock.world.grasped && mock.world.fault === 0);
  await until(() => mock.received.newest > newest.at(-1), "and goes on from there");
  assert.deepEqual(mock.received.refused, []);
});

pageTest("hovering neither takes the hand nor loses it", {}, async ({ page, mock }) => {
  const hover = async () => { for (let k = 0; k < 12; k++) await page.mouse.move(200 + 40 * k, 300 + 10 * k); };
  await hover();
  assert.ok(!mock.holder && !mock.received.text.some(({ type }) => type === "hold"), "nobody asked");
  await drag(page, 20, 10, 4);
  await until(() => mock.world.grasped, "held");
  const place = await page.evaluate(() => window.thigma.hand.position);
  await hover();
  assert.deepEqual(await page.evaluate(() => window.thigma.hand.position), place, "and moves nothing");
  assert.ok(mock.holder && mock.world.grasped && mock.world.fault === 0);
  assert.equal(mock.received.text.filter(({ type }) => type === "hold").length, 1);
});

pageTest("another scene begins without the arrow, the ghost and the contacts of the one before", { device: "hand:" }, async ({ page, mock }) => {
  const marks = () => page.evaluate(() => { const { stage } = window.thigma;
    return [stage.force.group, stage.twist.group, stage.spring.group, stage.ghost.group].map(({ visible }) => visible)
      .concat(stage.marks.dots.count > 0, [stage.object.finest, ...stage.object.levels.values()].some(({ bytes }) => bytes.some((level) => level > 0))); });
  await page.waitForFunction(() => window.thigma.stage.force.group.visible && window.thigma.stage.marks.dots.count > 0);
  mock.silence(true); // a session that takes its time to begin
  const meshes = await page.evaluate(() => window.thigma.session.counts.mesh);
  mock.show();
  await page.waitForFunction((n) => window.thigma.session.counts.mesh === n + 2, meshes);
  assert.deepEqual(await marks(), Array(6).fill(false));
  mock.silence(false);
  await page.waitForFunction(() => window.thigma.stage.force.group.visible);
});

pageTest("levels that come later change neither the view nor the moment that is shown", { device: "hand:" }, async ({ page, mock }) => {
  await page.waitForFunction(() => window.thigma.stage.force.group.visible);
  await page.evaluate(() => { window.thigma.act.look([1, 0, 0]); window.thigma.act.zoom(0.7); });
  await drawnSince(page);
  mock.silence(true); // nothing but the levels
  await page.waitForFunction(() => { // until the last moment that was sent is the one that is shown
    const { stage, session } = window.thigma, last = window.thigma.last;
    window.thigma.last = session.snapshot;
    return last === session.snapshot && stage.last === last && !session.fresh;
  }, undefined, { polling: 500 });
  const seen = () => page.evaluate(() => { const { stage, session } = window.thigma;
    return { camera: stage.view.camera.position.toArray(), scale: stage.root.scale.x, root: stage.root.position.toArray(), object: stage.object.group.position.toArray(),
      force: stage.force.group.visible, time: session.snapshot?.time ?? null, veiled: !document.getElementById("veil").hidden }; });
  const before = await seen(), meshes = await page.evaluate(() => window.thigma.session.counts.mesh);
  await page.evaluate(() => { window.thigma.former = window.thigma.stage.object; });
  mock.show(true);
  await page.waitForFunction((n) => window.thigma.session.counts.mesh === n + 2 && window.thigma.stage.object !== window.thigma.former, meshes);
  assert.deepEqual(await seen(), before);
});

pageTest("Ctrl turns, Shift pushes away, the wheel zooms or pushes, Space lets go", {}, async ({ page, mock }) => {
  await drag(page, 1, 0, 1);
  const hand = () => page.evaluate(() => ({ position: window.thigma.hand.position, quaternion: window.thigma.hand.quaternion }));
  const one = await hand();
  await page.keyboard.down("Control");
  await drag(page, 60, 0, 3);
  await page.keyboard.up("Control");
  const two = await hand();
  assert.deepEqual(two.position, one.position);
  assert.ok(Math.abs(two.quaternion[2]) > 0.1, "about the upright axis");
  await page.keyboard.down("Shift");
  await drag(page, 0, -50, 3);
  await page.keyboard.up("Shift");
  const three = await hand();
  assert.deepEqual(three.quaternion, two.quaternion);
  const away = await page.evaluate(() => { const e = window.thigma.stage.view.camera.matrixWorld.elements; return [-e[8], -e[9], -e[10]]; });
  const way = three.position.map((value, k) => value - two.position[k]);
  assert.ok(Math.abs(Math.hypot(...way) - way.reduce((sum, value, k) => sum + value * away[k], 0)) < 1e-6, "straight away from the eye");
  const distance = await page.evaluate(() => window.thigma.stage.view.distance);
  await page.mouse.wheel(0, 200);
  await page.waitForFunction((before) => window.thigma.stage.view.distance > before, distance);
  assert.deepEqual((await hand()).position, three.position, "the wheel alone is the view's");
  await page.keyboard.press("Space");
  await until(() => !mock.world.grasped, "let go");
  const azimuth = await page.evaluate(() => window.thigma.stage.view.azimuth);
  await page.mouse.down({ button: "right" });
  await page.mouse.move(300, 300, { steps: 3 });
  await page.mouse.up({ button: "right" });
  assert.notEqual(await page.evaluate(() => window.thigma.stage.view.azimuth), azimuth);
  assert.ok(!mock.world.grasped);
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

pageTest("levels: patches of any, and the active ones where the finest is only lines", { device: "hand:", query: "?picture=full" }, async ({ page, mock }) => {
  await page.getByRole("tab", { name: "Levels" }).click();
  await page.getByRole("radio", { name: "lower block, level 2" }).click();
  await page.getByText("672 triangles in 36 convex patches; nowhere more than 320 µm off the original.").waitFor();
  await page.waitForFunction(() => window.thigma.stage.statics[0].levels.has(2));
  await page.getByRole("radio", { name: "upper block, level 5" }).click();
  await page.getByText("1 group of patches below, merged pairwise.").waitFor();
  await drawnSince(page);
  const parts = () => page.evaluate(() => [window.thigma.stage.object, ...window.thigma.stage.statics].map((body) =>
    [[0, body.finest], ...body.levels].map(([level, one]) => [level, one.solid.visible, one.uniforms.onlyActive.value, one.uniforms.tinted.value])));
  assert.deepEqual(await parts(), [[[0, true, 0, 1]], [[0, false, 0, 0], [2, true, 0, 1]]], "a free level tints the finest patches");
  const asked = () => mock.received.text.filter(({ type }) => type === "level").map(({ mesh, value }) => `${mesh} ${value}`);
  assert.deepEqual(asked(), ["1 2"], "free levels have no surface to ask for");
  for (const name of ["lower block as it is", "upper block as it is"]) await page.getByRole("radio", { name }).click();
  await page.keyboard.press("l");
  await page.waitForFunction(() => { // contacts come and go, so in one picture
    const { object } = window.thigma.stage;
    return [object.finest, object.levels.get(1), object.levels.get(2)].every((one) => one?.bytes.some((level) => level > 0));
  });
  assert.deepEqual([...new Set(asked())].sort(), ["0 1", "0 2", "1 1", "1 2"]);
  assert.equal(asked().length, 4, "each is asked for once");
});

pageTest("where the processor draws, the view keeps its size and coarser surfaces are drawn", { device: "hand:" }, async ({ page, mock }) => {
  const seen = () => page.evaluate(() => { const { stage } = window.thigma, { canvas } = stage, all = [stage.object, ...stage.statics];
    return { pixels: [canvas.width, canvas.height], view: [canvas.clientWidth, canvas.clientHeight], plain: stage.plain,
      drawn: all.map((body) => body.drawn),
      shown: all.map((body) => [[0, body.finest], ...body.levels].filter(([, one]) => one.solid.visible).map(([level]) => level)),
      ghost: [...stage.object.levels.values()].some(({ geometry }) => geometry === stage.ghost.glass.geometry) }; });
  const atLast = (off) => page.evaluate((off) => { const { stage } = window.thigma;
    Object.assign(stage, { resized: true, dirty: true });
    Object.assign(stage.pace, { step: 5, fixed: true });
    for (const body of [stage.object, ...stage.statics]) if (off) body.coarse = []; // as where none have come
  }, off);
  await drawnSince(page);
  await atLast(true);
  await page.waitForFunction(() => window.thigma.stage.object.drawn > 0 && window.thigma.stage.statics[0].drawn > 0);
  const coarse = await seen();
  assert.ok(coarse.plain && coarse.ghost, JSON.stringify(coarse));
  assert.deepEqual(coarse.pixels, coarse.view, "at the slowest as large as the view");
  assert.deepEqual(coarse.shown, coarse.drawn.map((level) => [level]), "one surface an object");
  assert.ok(mock.received.text.some(({ type, mesh, value }) => type === "level" && mesh === 0 && value === coarse.drawn[0]));
  await page.waitForFunction(() => { // contacts of all levels are marked on what is drawn
    const { object } = window.thigma.stage;
    return object.levels.get(object.drawn).uniforms.spotCount.value > 0;
  });
  await page.mouse.move(300, 300);
  await page.mouse.wheel(0, -4000); // so near that nothing but the original is fine enough
  await page.waitForFunction(() => window.thigma.stage.object.drawn === 0);
});

pageTest("coarser surfaces come from a worker, and colours of contacts lie on them as if all were drawn in one", { device: "hand:" }, async ({ page }) => {
  await page.evaluate(() => { const { stage } = window.thigma;
    stage.object.about.level_list = []; // as of contacts at full resolution
    Object.assign(stage, { resized: true });
    Object.assign(stage.pace, { step: 5, fixed: true }); });
  await page.waitForFunction(() => window.thigma.stage.object.coarse?.length === 10 && window.thigma.stage.object.drawn < 0);
  // On half of the hand's way the contacts lie between both objects, where nobody sees their colours: until some are seen.
  const handle = await page.waitForFunction(() => {
    const { stage } = window.thigma, { renderer, scene, view, object, canvas: { width, height } } = stage, gl = renderer.getContext();
    const surface = object.levels.get(object.drawn), { solid, stain, materials, bytes, near, byPatch } = surface;
    if (!stain.visible) return null;
    const picture = () => { // in one task, so that nothing comes between
      renderer.render(scene, view.camera);
      const pixels = new Uint8Array(4 * width * height);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      return pixels;
    };
    const draw = (isStained, material) => { stain.visible = isStained; solid.material = material; return picture(); };
    const differing = (a, b, most) => { const at = []; for (let k = 0; k < a.length; k += 4) if ([0, 1, 2].some((c) => Math.abs(a[k + c] - b[k + c]) > most)) at.push(k / 4); return at; };
    const compare = () => { // two drawings, without the colours, and one drawing
      const twice = draw(true, materials.bare), without = draw(false, materials.bare), once = draw(false, materials.plain);
      return { at: differing(twice, without, 8), different: differing(twice, once, 2).length };
    };
    const far = compare();
    if (far.at.length <= 20) { draw(true, materials.bare); return null; }
    // Near enough that the colours fill the view: of a few pixels most lie at an edge.
    const xs = far.at.map((k) => k % width), ys = far.at.map((k) => height - 1 - Math.floor(k / width));
    const [left, top] = [Math.min(...xs), Math.min(...ys)], part = Math.max((Math.max(...xs) - left + 1) / width, (Math.max(...ys) - top + 1) / height);
    view.camera.setViewOffset(width, height, left, top, part * width, part * height);
    const close = compare();
    view.camera.clearViewOffset();
    draw(true, materials.bare);
    const stained = close.at.length, { different } = close;
    const coloured = [...bytes.keys()].filter((patch) => bytes[patch] || near[patch]).reduce((sum, patch) => sum + byPatch.begin[patch + 1] - byPatch.begin[patch], 0);
    return { stained, different, far: far.at.length, coloured, drawn: stain.geometry.drawRange.count / 3,
      triangles: object.coarse.map((one) => one.triangles), fine: object.about.triangles, level: object.drawn };
  });
  const seen = await handle.jsonValue();
  assert.ok(seen.different <= 0.02 * seen.stained, `${seen.different} of ${seen.stained} pixels are not those of one drawing`);
  assert.equal(seen.drawn, seen.coloured);
  assert.ok(seen.triangles.every((n, k) => n <= (k === 0 ? seen.fine : seen.triangles[k - 1])) && seen.triangles.at(-seen.level) < 0.7 * seen.fine, JSON.stringify(seen));
});

pageTest("relief is drawn in place of the smooth surface, and sound follows the force", { device: "hand:", query: "?picture=full" }, async ({ page, mock }) => {
  await drawnSince(page);
  mock.relief(1);
  await page.waitForFunction(() => window.thigma.stage.statics[0].relief?.solid.visible);
  const seen = await page.evaluate(() => { const { statics: [body], object } = window.thigma.stage;
    return { smooth: body.finest.solid.visible, object: object.finest.solid.visible && object.relief === null }; });
  assert.deepEqual(seen, { smooth: false, object: true });
  await page.waitForFunction(() => window.thigma.stage.statics[0].relief.bytes.some((level) => level > 0)); // contacts mark it
  await page.keyboard.press("l");
  await page.waitForFunction(() => !window.thigma.stage.statics[0].relief.solid.visible);
  await page.keyboard.press("l");
  assert.ok(await page.evaluate(() => window.thigma.sound.context === null), "silent until asked");
  await page.getByRole("button", { name: "Sound of contact" }).click();
  await page.waitForFunction(() => window.thigma.sound.played > 3);
  await page.keyboard.press("s");
  const played = await page.evaluate(() => window.thigma.sound.played);
  await drawnSince(page);
  assert.equal(await page.evaluate(() => window.thigma.sound.played), played);
});

pageTest("a scene, a recording and a mesh of one's own are opened from the menu", { device: "hand:" }, async ({ page, mock }) => {
  await page.getByRole("button", { name: "Open a scene" }).click();
  await page.getByRole("button", { name: "Cup and spoon" }).click();
  await page.getByText("Building levels of cup …").waitFor();
  assert.equal(mock.opened, "cups");
  assert.ok(!await page.evaluate(() => document.getElementById("opener").open), "nothing stands before the progress");
  assert.ok(await page.evaluate(() => Math.abs(document.querySelector("#veil progress").value - 0.4) < 1e-6));
  await page.getByRole("button", { name: "Cancel" }).click();
  await until(() => mock.cancelled, "given up");
  await page.waitForFunction(() => document.getElementById("veil").hidden);
  await page.keyboard.press("o");
  await page.locator("#opener").getByRole("button", { name: "session-001.mcap" }).click();
  const slider = page.getByLabel("Time in the recording");
  await slider.waitFor();
  await slider.fill("12.5");
  await until(() => mock.received.text.some(({ type, value }) => type === "seek" && value === 12.5), "the slider's time");
  await page.getByText("A recording: session-001.mcap").waitFor();
  await page.getByLabel("How fast it is shown").selectOption("0.25");
  await until(() => mock.replay.speed === 0.25, "slow motion");
  assert.ok(await page.evaluate(() => { const strip = document.querySelector(".track canvas"), { width, height } = strip;
    const { data } = strip.getContext("2d").getImageData(0, 0, width, height);
    return width > 100 && data.some((value, k) => k % 4 === 3 && value > 0) && data.some((value, k) => k % 4 === 3 && value === 0); }), "the force over the recording");
  await page.getByRole("button", { name: "Take it yourself" }).click();
  await slider.waitFor({ state: "hidden" });
  const bytes = Buffer.from(Array.from({ length: 150000 }, (_, k) => (k * k) % 251));
  await page.keyboard.press("o");
  await page.locator("#mesh-file").setInputFiles({ name: "cup.stl", mimeType: "model/stl", buffer: bytes });
  await page.getByText("Needs repair first").waitFor();
  assert.ok(mock.uploaded.equals(bytes), "every byte, in order");
  await page.getByText("2 duplicate faces").waitFor();
  await page.getByLabel("Its unit is").selectOption({ label: "centimetres (400 mm)" });
  await page.getByRole("button", { name: "Repair and hold it" }).click();
  await until(() => mock.placed, "placed");
  assert.deepEqual(mock.placed, { how: "hold", unit: 0.01, repair: true });
  const dropped = await page.evaluateHandle(() => { const data = new DataTransfer(); data.items.add(new File(["x"], "bad.obj")); return data; });
  await page.dispatchEvent("#scene", "drop", { dataTransfer: dropped });
  await page.getByText("Cannot be used").waitFor();
  assert.equal(await page.getByRole("button", { name: /Hold it/ }).count(), 0);
});

pageTest("pause, step, reset, record, save", { device: "hand:" }, async ({ page, mock }) => {
  await page.getByRole("button", { name: "Pause" }).click();
  await until(() => mock.run === "paused", "pause");
  await page.getByText("Contacts: paused.").waitFor(); // and not that they are found 0.00 times a second
  const frame = mock.world.frame;
  await page.getByRole("button", { name: "One step" }).click();
  await until(() => mock.world.frame === frame + 1, "one step");
  await page.getByRole("button", { name: "Go on" }).click();
  await until(() => mock.run === "running", "going on");
  await page.getByRole("button", { name: "Record" }).click();
  await until(() => mock.recording, "recording");
  await page.getByRole("button", { name: "Stop recording" }).click();
  await until(() => !mock.recording, "no recording");
  await page.getByRole("button", { name: "Begin again" }).click();
  await until(() => mock.session === 2, "a new session");
  await page.waitForFunction(() => window.thigma.session.state.session === 2);
  for (const [name, ending] of [["Save the plots as a picture", "png"], ["Save the plots as a table", "csv"]]) {
    const coming = page.waitForEvent("download");
    await page.getByRole("button", { name }).click();
    assert.match((await coming).suggestedFilename(), new RegExp(`^thigma-.*\\.${ending}$`));
  }
});

pageTest("a lost connection is said, holds nothing, and comes back", { mayReport: /WebSocket/ }, async ({ page, mock }) => {
  await drag(page, 20, 0, 3);
  await until(() => mock.world.grasped, "held");
  mock.drop();
  await page.waitForFunction(() => document.body.classList.contains("lost") || window.thigma.link.attempt > 0 || !window.thigma.session.holding);
  assert.equal(await page.evaluate(() => window.thigma.hand.clutch), false);
  assert.equal(mock.world.fault, 1);
  await page.waitForFunction(() => window.thigma.session.connected && window.thigma.session.counts.mesh >= 4);
  await page.getByText("Forces are off: the hand was lost.").waitFor();
  const device = mock.received.device;
  await page.waitForFunction((n) => window.thigma.session.counts.snapshot > n, await page.evaluate(() => window.thigma.session.counts.snapshot + 20));
  assert.equal(mock.received.device, device, "nothing is sent until somebody takes hold");
  await drag(page, 10, 0, 2);
  await until(() => mock.world.fault === 0 && mock.world.grasped, "resumed by a new press");
});

pageTest("a program that falls silent is noticed", { mayReport: /WebSocket/ }, async ({ page, mock }) => {
  mock.silence(true);
  await page.getByText("The program has stopped talking.").waitFor();
  mock.silence(false);
  await page.waitForFunction(() => window.thigma.session.connected);
});

pageTest("what the page does not understand is said, once", {}, async ({ page, mock }) => {
  for (const one of mock.pages) one.sendBinary(Buffer.alloc(20, 7));
  await page.getByText("The program says something this page does not understand: message type 7 is not known.").waitFor();
  await new Promise((resolve) => setTimeout(resolve, 1500));
  assert.equal(mock.pages.size, 0, "no second attempt with the same program");
});

pageTest("a gamepad moves the hand and rumbles", { prepare: () => {
  window.rumbles = 0;
  const pad = { connected: true, axes: [0.5, 0, 0, 0], buttons: Array.from({ length: 17 }, (_, k) => ({ pressed: k === 0, value: k === 7 ? 0.5 : 0 })),
    vibrationActuator: { playEffect: async () => { window.rumbles += 1; } } };
  navigator.getGamepads = () => (window.padOn ? [null, pad] : []);
} }, async ({ page, mock }) => {
  await page.evaluate(() => { window.padOn = true; dispatchEvent(new Event("gamepadconnected")); });
  await until(() => mock.world.lift > 0.0005, "contact");
  await page.waitForFunction(() => window.rumbles > 0);
  assert.deepEqual(mock.received.refused, []);
});

pageTest("a finger on the object moves it, one beside it turns the view", { context: { hasTouch: true, viewport: { width: 390, height: 844 } } },
  async ({ page, mock }) => {
    await drawnSince(page);
    const session = await page.context().newCDPSession(page);
    const touch = (type, points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points });
    const at = await page.evaluate(() => {
      const { stage } = window.thigma, box = stage.canvas.getBoundingClientRect();
      const p = stage.object.group.getWorldPosition(stage.view.target.clone()).project(stage.view.camera);
      return { x: box.left + ((p.x + 1) / 2) * box.width, y: box.top + ((1 - p.y) / 2) * box.height, left: box.left + 15, top: box.bottom - 90 };
    });
    await touch("touchStart", [{ x: at.x, y: at.y }]);
    await page.waitForFunction(() => window.thigma.session.holding && window.thigma.hand.clutch);
    await touch("touchMove", [{ x: at.x + 30, y: at.y }]);
    await until(() => mock.world.hand && Math.hypot(...mock.world.hand.position) > 0.001, "moved by a finger");
    const before = await page.evaluate(() => window.thigma.hand.quaternion);
    await touch("touchStart", [{ x: at.x + 30, y: at.y }, { x: at.x + 90, y: at.y }]);
    await touch("touchMove", [{ x: at.x + 30, y: at.y }, { x: at.x + 80, y: at.y + 40 }]);
    await page.waitForFunction((q) => window.thigma.hand.quaternion.some((value, k) => Math.abs(value - q[k]) > 0.05), before);
    await touch("touchEnd", []);
    const azimuth = await page.evaluate(() => window.thigma.stage.view.azimuth);
    await touch("touchStart", [{ x: at.left, y: at.top }]);
    await touch("touchMove", [{ x: at.left + 60, y: at.top }]);
    await page.waitForFunction((old) => window.thigma.stage.view.azimuth !== old, azimuth);
    await touch("touchEnd", []);
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

test("nothing comes from elsewhere, and a foreign page is not let in", PATIENCE, async (t) => {
  if (reason) { t.skip(reason); return; }
  const mock = await startMock();
  const { page, context } = await openPage(browser, "about:blank");
  const hosts = new Set();
  page.on("request", (request) => hosts.add(new URL(request.url()).host));
  await page.goto(`http://127.0.0.1:${mock.port}/`);
  await page.waitForFunction(() => window.thigma?.session.counts.snapshot > 2);
  assert.deepEqual([...hosts], [`127.0.0.1:${mock.port}`]);
  await context.close();
  mock.close();
});
