// The page against the program itself: THIGMA_PROGRAM names it (ctest does). What the page shows is compared with what the
// engine says of itself in its snapshots.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { startProgram } from "../program.mjs";
import { openPage, startBrowser } from "./browser.mjs";

const program = process.env.THIGMA_PROGRAM;
const SHOTS = process.env.THIGMA_SHOTS;
const PATIENCE = { timeout: 400000 };
let browser = null, reason = null;

before(async () => {
  if (!program || !existsSync(program)) reason = "no program to run (THIGMA_PROGRAM is not set or not there)";
  else ({ browser, reason } = await startBrowser());
});
after(async () => { await browser?.close(); });

const here = dirname(fileURLToPath(import.meta.url));
const SMALL = [join(here, "small.toml"), "--exact"];

/// A session in lockstep, which no machine is too slow for, to be shown again: the arguments for it.
function recorded() {
  const folder = mkdtempSync(join(tmpdir(), "thigma-recorded-"));
  const file = join(folder, "session.mcap");
  execFileSync(program, ["run", SHOTS ? "jaws" : join(here, "../../../../scenes/ellipsoid.toml"), "--response", "penalty", "--headless", "--lockstep", "--duration", SHOTS ? "6" : "3",
    "--record", file, "--quiet"], { stdio: "ignore" });
  return { args: ["--replay", file], done: () => rmSync(folder, { recursive: true, force: true }) };
}

function liveTest(name, device, body, scene = SMALL, query = "") {
  test(name, PATIENCE, async (t) => {
    if (reason) { t.skip(reason); return; }
    const { args, done } = typeof scene === "function" ? scene() : { args: scene, done: () => {} };
    const run = await startProgram(program, [...args, "--device", device]);
    const { page, errors, context } = await openPage(browser, `${run.address}/${query}`);
    page.setDefaultTimeout(150000);
    try {
      await page.waitForFunction(() => window.thigma?.session.counts.snapshot > 5 && window.thigma.stage.object && window.thigma.drawn > 0);
      await body({ page, run, t });
      assert.deepEqual(errors, []);
    } finally {
      await context.close();
      await run.end();
      done();
    }
  });
}

const session = (page, read) => page.evaluate((text) => new Function("s", `return ${text};`)(window.thigma.session), read);

/// Takes hold and drags down in the picture, seen from the side, until there is force. On a busy machine the hand may count
/// less than fully; where a frame of the engine was late, or a press was, it lifts the object off first, as a person would
/// who is told so.
/// Returns false where the machine let go of it again and again: too slow to press anything.
async function pressDown(page) {
  const box = await page.locator("#scene").boundingBox();
  const x = Math.round(box.x + box.width / 2), y = Math.round(box.y + box.height / 2);
  await page.mouse.move(x, y);
  await page.mouse.down({ button: "right" });
  await page.mouse.move(x, y - 66);
  await page.mouse.up({ button: "right" });
  const reach = box.height / 2 - 5;  // of a hand in the picture; then it takes hold again, higher up
  let down = 0, held = false, hurdles = 0, steady = 0, turns = 0;
  for (const end = Date.now() + 90000; Date.now() < end; ++turns) {
    const { holds, armed, newtons } = await page.evaluate(() => { const { session: s, hand } = window.thigma;
      return { holds: s.holding && hand.clutch, armed: (s.snapshot.bits & 2) !== 0, newtons: Math.hypot(...s.snapshot.force) }; });
    steady = newtons > 0.4 ? steady + 1 : 0;  // the first touch is a bounce
    if (steady > 5) { await page.mouse.up(); return true; }
    if (held && !holds) ++hurdles;
    held = holds;
    if (!holds) {
      await page.mouse.up();
      await page.mouse.move(x, y);
      await page.mouse.down();
      down = 0;
      await page.waitForFunction(() => window.thigma.session.holding && window.thigma.hand.clutch, null, { timeout: 10000 })
        .catch(() => { ++hurdles; });
    } else if (steady > 0) {
      // hold still
    } else if (Math.abs(down) < reach) {
      down += armed ? 2 : -2;
      await page.mouse.move(x, y + down);
    } else {
      await page.mouse.up();
      held = false;
    }
    await page.waitForTimeout(40);
  }
  assert.ok(hurdles > 2 || turns < 600, "held, and never pressed");
  return false;
}

/// What page and engine say while the hand presses, drawn at least twice since; null where the machine was too slow for it.
async function readPressed(page) {
  for (let attempt = 0; attempt < 3 && await pressDown(page); ++attempt) {
    const from = await page.evaluate(() => window.thigma.drawn);
    await page.waitForFunction((n) => window.thigma.drawn > n + 2, from);
    const seen = await page.evaluate(() => {
      const { stage, session: s, plots, hand } = window.thigma;
      return { drawn: stage.object.group.position.toArray(), engine: stage.last.object.position, ghost: stage.ghost.group.position.toArray(),
        arrow: stage.force.group.visible, penetration: s.snapshot.penetration, stretch: s.snapshot.stretch, tolerance: s.scene.tolerance,
        contacts: s.snapshot.contacts.length, rows: plots.rows, faults: s.snapshot.bits & 4, holds: s.holding && hand.clutch };
    });
    if (seen.holds && seen.faults === 0) return seen;
  }
  return null;
}

const TOO_SLOW = "this machine was too busy to hold the device";

liveTest("what the page asks for happens", "hand:", async ({ page }) => {
  await page.getByRole("button", { name: "Pause" }).click();
  await page.waitForFunction(() => window.thigma.session.state.run === "paused" && (window.thigma.session.snapshot.bits & 8) !== 0);
  const frame = await session(page, "s.snapshot.frame");
  await page.getByRole("button", { name: "One step" }).click();
  await page.waitForFunction((n) => window.thigma.session.snapshot.frame > n, frame);
  await page.getByRole("button", { name: "Go on" }).click();
  await page.waitForFunction(() => window.thigma.session.state.run === "running");
  await page.getByRole("tab", { name: "Parameters" }).click();
  const stiffness = page.getByLabel("coupling stiffness, N/m");
  const value = Number(await stiffness.inputValue());
  await stiffness.fill(String(0.8 * value));
  await stiffness.press("Enter");
  await page.waitForFunction((now) => window.thigma.session.parameters.some((one) => one.name === "coupling_stiffness" &&
    Math.abs(one.value - now) < 1e-6 * now), 0.8 * value);
  const number = await session(page, "s.state.session");
  await page.getByRole("button", { name: "Begin again" }).click();
  await page.waitForFunction((n) => window.thigma.session.state.session > n, number);
  await page.getByRole("button", { name: "Take it yourself" }).click();
  await page.waitForFunction(() => window.thigma.session.state.device === "web:" && window.thigma.session.state.holder === "you");
});

const CORNERS = [[15, 0, 0], [-15, 0, 0], [0, 15, 0], [0, -15, 0], [0, 0, 15], [0, 0, -15]];
const FACES = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
const lines = (list, write) => list.map((one) => `${write(one)}\n`).join("");
const OCTAHEDRON = {
  obj: lines(CORNERS, (c) => `v ${c.join(" ")}`) + lines(FACES, (f) => `f ${f.map((v) => v + 1).join(" ")}`),
  stl: `solid octahedron\n${lines(FACES, (f) => `facet normal 0 0 0\nouter loop\n${lines(f, (v) => `vertex ${CORNERS[v].join(" ")}`)}endloop\nendfacet`)}endsolid\n`,
  ply: `ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\nelement face 8\n` +
    `property list uchar int vertex_indices\nend_header\n${lines(CORNERS, (c) => c.join(" "))}${lines(FACES, (f) => `3 ${f.join(" ")}`)}`,
};

liveTest("a drag moves the object until it presses, and not through", "web:", async ({ page, t }) => {
  const start = await session(page, "s.snapshot.object.position[2]");
  const seen = await readPressed(page);
  if (!seen) { t.skip(TOO_SLOW); return; }
  assert.deepEqual(seen.drawn, seen.engine, "drawn where the engine has it");
  assert.ok(seen.engine[2] < start, "it went down");
  assert.ok(seen.arrow && seen.contacts > 0 && seen.rows > 100 && seen.faults === 0, JSON.stringify(seen));
  assert.ok(seen.ghost[2] < seen.engine[2], "the ghost is below the object");
  assert.ok(seen.penetration < 0.5 * seen.stretch, "the surfaces give less than the hand");
});

liveTest("a recording is shown at any time, and a mesh of one's own is held and touches", "hand:", async ({ page }) => {
  await page.getByRole("button", { name: "Record" }).click();
  await page.waitForFunction(() => window.thigma.session.state.recording && Math.hypot(...window.thigma.session.snapshot.force) > 0.2);
  await page.getByRole("button", { name: "Stop recording" }).click();
  await page.waitForFunction(() => !window.thigma.session.state.recording);
  await page.keyboard.press("o");
  await page.locator("#opener").getByRole("button", { name: "session-001.mcap" }).click();
  const slider = page.getByLabel("Time in the recording");
  await slider.waitFor();
  await page.waitForFunction(() => !document.getElementById("opener").open && window.thigma.session.state.replay);
  await page.getByRole("button", { name: "Hold", exact: true }).click();
  await page.waitForFunction(() => window.thigma.session.state.run === "paused");
  const end = await session(page, "s.state.replay.seconds");
  let before = -1;
  for (const share of [0.3, 1]) { // a busy machine leaves frames out, nearly all at times: the first and the last are there
    await slider.fill(String(share * end));
    await page.waitForFunction(([low, high]) => { const { time } = window.thigma.session.snapshot; return time > low && time <= high; },
      [before, share * end + 1e-6]);
    before = await session(page, "s.snapshot.time");
  }
  await page.waitForFunction(() => { const { stage, session: s } = window.thigma;
    return stage.last === s.snapshot && stage.object.group.position.toArray().every((value, k) => value === s.snapshot.object.position[k]); });
  await page.keyboard.press("o");
  await page.locator("#mesh-file").setInputFiles({ name: "octahedron.obj", mimeType: "model/obj", buffer: Buffer.from(OCTAHEDRON.obj) });
  await page.getByText("Ready to use").waitFor();
  await page.getByRole("button", { name: "Hold it" }).click();
  await page.waitForFunction(() => window.thigma.session.scene.object.name === "octahedron.obj" && window.thigma.stage.object &&
    window.thigma.session.state.replay === null && Math.hypot(...(window.thigma.session.snapshot?.force ?? [0])) > 0.1);
  assert.equal(await session(page, "s.scene.object.triangles"), 8);
});

liveTest("STL and PLY files dropped on the page are touched and held", "hand:", async ({ page }) => {
  for (const [ending, how] of [["stl", "Touch it"], ["ply", "Hold it"]]) {
    const name = `octahedron.${ending}`;
    const dropped = await page.evaluateHandle(([text, as]) => { const data = new DataTransfer(); data.items.add(new File([text], as)); return data; },
      [OCTAHEDRON[ending], name]);
    await page.dispatchEvent("#scene", "drop", { dataTransfer: dropped });
    await page.getByText("Ready to use").waitFor();
    await page.getByRole("button", { name: how, exact: true }).click();
    await page.waitForFunction(([as, isHeld]) => { const { scene, snapshot } = window.thigma.session;
      const { name: shown, triangles } = isHeld ? scene.object : scene.statics[0];
      return shown === as && triangles === 8 && Math.hypot(...(snapshot?.force ?? [0])) > 0.1; }, [name, how === "Hold it"]);
  }
  assert.equal(await session(page, "s.scene.statics[0].name"), "octahedron.stl", "what was touched stays");
});

liveTest("texture is switched off and on", "hand:", async ({ page }) => {
  await page.getByRole("tab", { name: "Parameters" }).click();
  const choices = page.getByRole("radiogroup", { name: "texture" });
  for (const word of ["off", "on"]) {
    const number = await session(page, "s.state.session");
    await choices.getByRole("radio", { name: word, exact: true }).click();
    await page.waitForFunction(([before, value]) => { const { session: s } = window.thigma;
      return s.state.session > before && s.parameters.find(({ name }) => name === "texture").value === value &&
        Math.hypot(...(s.snapshot?.force ?? [0])) > 0.1; }, [number, word === "off" ? 1 : 0]);
    assert.equal(await choices.locator("[aria-checked=true]").textContent(), word);
  }
}, [join(here, "ridged.toml")]);

// THIGMA_SHOTS=DIR: the same with the jaws in full quality, and the pictures of the documents.
const shot = (page, name) => SHOTS && page.screenshot({ path: join(SHOTS, `${name}.png`) });

async function drawnAgain(page) {
  const from = await page.evaluate(() => window.thigma.drawn);
  await page.waitForFunction((n) => window.thigma.drawn > n, from);
}

liveTest("levels of the engine: in contact, by themselves, light and dark", "hand:", async ({ page }) => {
  await page.waitForFunction(() => window.thigma.session.state?.replay);
  await page.evaluate(() => window.thigma.act.pause());
  await page.waitForFunction(() => window.thigma.session.state.run === "paused");
  const end = await session(page, "s.state.replay.seconds");
  let pressed = false; // where the hand presses: the first such time from the end
  for (let time = end; !pressed && time > 0; time -= 0.1) {
    await page.evaluate((t) => window.thigma.act.seek(t), time);
    await page.waitForFunction((t) => { const s = window.thigma.session.snapshot; return s && Math.abs(s.time - t) < 0.0021; }, time);
    pressed = await session(page, `s.snapshot.contacts.length > 0 && Math.hypot(...s.snapshot.force) > ${SHOTS ? 0.7 : 0.2}`);
  }
  assert.ok(pressed, "the recording presses");
  await page.waitForFunction(() => window.thigma.plots.fast.used > 30); // thinned, the seconds before
  await page.waitForFunction(() => window.thigma.session.snapshot.contacts.length > 0);
  await drawnAgain(page);
  await shot(page, "live");
  await page.emulateMedia({ colorScheme: "dark" });
  await drawnAgain(page);
  await shot(page, "live-dark");
  await page.emulateMedia({ colorScheme: "light" });
  await page.keyboard.press("l");
  const wanted = await page.evaluate(() => { const { stage, session: s } = window.thigma;
    return [...new Set(s.snapshot.contacts.map((c) => c.objectLevel))].filter((level) => level > 0 && !s.scene.object.level_list[level].free); });
  await page.waitForFunction((levels) => levels.every((level) => window.thigma.stage.object.levels.has(level)), wanted);
  await drawnAgain(page);
  const active = await page.evaluate(() => { const { object } = window.thigma.stage;
    return [object.finest, ...object.levels.values()].reduce((sum, one) => sum + one.bytes.filter((level) => level > 0).length, 0); });
  assert.ok(active > 0, "patches in contact are drawn");
  await shot(page, "live-levels");
  await page.keyboard.press("l");
  await page.getByRole("tab", { name: "Levels" }).click();
  const browsed = await page.evaluate(() => { const { level_list: list } = window.thigma.session.scene.statics[0];
    return list.reduce((best, { free }, level) => (free ? best : level), 0); });
  assert.ok(browsed > 0, "the scene has simplified levels");
  for (const [body, level] of [[0, SHOTS ? 3 : 1], [1, SHOTS ? 3 : browsed]]) {
    await page.locator(".level-row").nth(body).getByRole("radio", { name: new RegExp(`, level ${level}$`) }).click();
  }
  await page.waitForFunction((level) => window.thigma.stage.statics[0].levels.has(level), SHOTS ? 3 : browsed);
  if (SHOTS) for (const key of "gca") await page.keyboard.press(key);
  await drawnAgain(page);
  await shot(page, "live-browser");
}, recorded, SHOTS ? "?picture=full" : "");

/// How far the outline of each object as it is drawn lies off that of its original, in pixels, at most; with how many pixels
/// they cover. One by one: where two outlines meet at a narrow angle the place goes farther than either.
function outlineOff() {
  const REACH = 8; // farther is not looked for [px]
  const { stage } = window.thigma, { renderer, scene, view, object, statics } = stage, gl = renderer.getContext();
  const width = gl.drawingBufferWidth, height = gl.drawingBufferHeight, bodies = [object, ...statics];
  const mask = () => {
    renderer.render(scene, view.camera);
    const data = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
    return Uint8Array.from({ length: width * height }, (_, k) => (data[4 * k + 3] > 0 ? 1 : 0));
  };
  for (const { group } of [stage.ghost, stage.marks, stage.force, stage.twist, stage.spring, stage.rows]) group.visible = false;
  let farthest = 0, covered = 0;
  const compare = (drawn, whole) => {
    for (let y = REACH; y < height - REACH; y++) {
      for (let x = REACH; x < width - REACH; x++) {
        const at = y * width + x;
        covered += whole[at];
        if (whole[at] === drawn[at]) continue;
        let nearest = REACH + 1;
        for (let dy = -REACH; dy <= REACH; dy++) for (let dx = -REACH; dx <= REACH; dx++) {
          if (whole[at + dy * width + dx] === drawn[at]) nearest = Math.min(nearest, Math.hypot(dx, dy));
        }
        farthest = Math.max(farthest, nearest);
      }
    }
  };
  for (const body of bodies) {
    for (const other of bodies) other.group.visible = other === body;
    const drawn = mask();
    const shown = [body.finest, ...body.levels.values()].map((one) => [one, one.solid.visible]);
    for (const [one] of shown) one.solid.visible = one === body.finest;
    compare(drawn, mask());
    for (const [one, visible] of shown) one.solid.visible = visible;
  }
  for (const body of bodies) body.group.visible = true;
  return { levels: bodies.map((body) => body.drawn), farthest, covered };
}

liveTest("where pictures are slow, coarser surfaces are drawn, outlines no farther off than allowed", "hand:", async ({ page }) => {
  await page.evaluate(() => window.thigma.act.pause());
  await page.waitForFunction(() => window.thigma.session.state.run === "paused");
  let coarsest = 0;
  for (const [step, allowed, ofAsset] of [[3, 0.5, false], [4, 1, false], [5, 2, false], [5, 2, true]]) { // of the page, then of the asset
    await page.evaluate((k) => { const { stage } = window.thigma;
      Object.assign(stage.pace, { step: k, fixed: true });
      Object.assign(stage, { resized: true, dirty: true }); }, step);
    await drawnAgain(page); // asks for what it lacks
    await page.waitForFunction(() => [window.thigma.stage.object, ...window.thigma.stage.statics].every(({ about, coarse }) => about.triangles < 4000 || coarse?.length === 10));
    if (ofAsset) await page.evaluate(() => { const { stage } = window.thigma; for (const body of [stage.object, ...stage.statics]) body.coarse = []; stage.dirty = true; });
    await drawnAgain(page);
    await page.waitForFunction(() => window.thigma.stage.wanted.size === [window.thigma.stage.object, ...window.thigma.stage.statics]
      .reduce((sum, { levels }) => sum + [...levels.keys()].filter((level) => level > 0).length, 0));
    let seen = null;
    const most = allowed + Math.SQRT2; // pixels are known to half their diagonal, on either outline
    for (let turn = 0; turn < 3 && !(seen?.farthest <= most); ++turn) { // the session stands still: what is off stays off
      await page.evaluate(() => { window.thigma.stage.dirty = true; });
      await drawnAgain(page);
      seen = await page.evaluate(outlineOff);
    }
    assert.ok(seen.covered > 20000 && seen.farthest <= most, JSON.stringify(seen));
    assert.ok(ofAsset ? seen.levels.every((level) => level > 0) : seen.levels[1] < 0, JSON.stringify(seen)); // the probe has few triangles
    if (!ofAsset) coarsest = Math.min(coarsest, ...seen.levels);
  }
  assert.ok(coarsest < -3, `level ${coarsest} at the most`);
}, ["ellipsoid", "--response", "penalty"]);

const JAWS = `title = "Upper jaw on lower jaw, contacts as constraints"
[object]
name = "upper jaw"
mesh = "procedural:jaw_upper?triangles=47340&seed=1"
position = [0.0, 0.0, 0.003]
mass = 0.010
grasp_point = [0.0, 0.030, 0.015]
[[static]]
name = "lower jaw"
mesh = "procedural:jaw_lower?triangles=40180&seed=1"
[contact]
response = "constraint"
friction = 0.3
`;

/// A session under constraints with friction, to be shown again.
function recordedRows() {
  const folder = mkdtempSync(join(tmpdir(), "thigma-recorded-"));
  const file = join(folder, "session.mcap"), jaws = join(folder, "jaws.toml");
  writeFileSync(jaws, JAWS);
  execFileSync(program, ["run", SHOTS ? jaws : join(here, "rows.toml"), "--exact", "--headless", "--lockstep", "--duration", "3", "--device", "hand:", "--record", file,
    "--quiet"], { stdio: "ignore" });
  return { args: ["--replay", file], done: () => rmSync(folder, { recursive: true, force: true }) };
}

liveTest("under constraints the rows of the engine are drawn, add up, and keep the object out, light and dark", "hand:", async ({ page }) => {
  await page.waitForFunction(() => window.thigma.session.state?.replay);
  await page.evaluate(() => window.thigma.act.pause());
  await page.waitForFunction(() => window.thigma.session.state.run === "paused");
  const end = await session(page, "s.state.replay.seconds");
  let pressed = false;
  for (let time = 0.9 * end; !pressed && time > 0; time -= 0.1) {
    await page.evaluate((t) => window.thigma.act.seek(t), time);
    await page.waitForFunction((t) => { const s = window.thigma.session.snapshot; return s && Math.abs(s.time - t) < 0.0021; }, time);
    pressed = await session(page, "s.snapshot.rows.filter((r) => r.presses).length > 2 && s.snapshot.stretch > 1e-3 && Math.hypot(...s.snapshot.force) > 0.3");
  }
  assert.ok(pressed, "the recording presses");
  for (const scheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme: scheme });
    await drawnAgain(page);
    await page.waitForFunction(() => /rests on \d+ rows/.test(document.querySelector(".situation").textContent));
    const seen = await page.evaluate(() => { const { stage, session: s } = window.thigma, count = (name) => stage.rows[name].count;
      return { rows: s.snapshot.rows, contact: s.snapshot.contactForce, size: stage.size, bits: s.snapshot.bits, constraint: s.state.constraint,
        object: s.snapshot.object.position, ghost: s.snapshot.ghost.position, planes: count("planes"), forces: count("forces"), cones: count("cones"),
        words: document.getElementById("readouts").textContent, legend: document.getElementById("row-legend").textContent }; });
    const pressing = seen.rows.filter(({ presses }) => presses);
    assert.ok(seen.bits & 256 && seen.constraint.left_out === 0 && seen.constraint.in_model >= seen.rows.length, JSON.stringify(seen.constraint));
    assert.ok(seen.rows.every(({ gap }) => gap > -1e-6 * seen.size), "nothing is inside");
    assert.ok(pressing.every(({ gap }) => gap < 1e-3 * seen.size), "what presses touches");
    const sum = [0, 1, 2].map((k) => pressing.reduce((total, { force }) => total + force[k], 0));
    assert.ok(Math.hypot(...sum.map((value, k) => value - seen.contact[k])) < 0.01 * Math.hypot(...seen.contact), `${sum} ${seen.contact}`);
    for (const { force, normal, friction } of pressing) {
      const along = force.reduce((total, value, k) => total + value * normal[k], 0), size = Math.hypot(...force);
      assert.ok(along < 0 && Math.sqrt(Math.max(0, size * size - along * along)) < 1.001 * friction * -along, "within its cone");
    }
    assert.deepEqual([seen.forces, seen.cones], [pressing.length, pressing.length]);
    assert.ok(seen.planes > 0 && seen.ghost[2] < seen.object[2], "the hand is inside, the object is not");
    assert.match(seen.words, new RegExp(`rests on ${pressing.length} rows of the (plate|lower jaw); the hand pulls`));
    assert.match(seen.legend, new RegExp(`rows that press×${pressing.length}friction cone×${pressing.length}`));
    await shot(page, scheme === "light" ? "live-constraint" : "live-constraint-dark");
  }
}, recordedRows, SHOTS ? "?picture=full" : "");

/// Another page of the same session that watches and draws nothing, so that it takes no processor from the one that holds.
async function openWatcher(address) {
  const watcher = await openPage(browser, "about:blank");
  await watcher.page.addInitScript(() => { window.requestAnimationFrame = () => 0; });
  await watcher.page.goto(address);
  await watcher.page.waitForFunction(() => window.thigma?.session.counts.snapshot > 5, null, { polling: 50 });
  return watcher;
}

liveTest("a page that goes leaves no force behind", "web:", async ({ page, run, t }) => {
  const watcher = await openWatcher(run.address);
  const newtons = (from) => session(from, "Math.hypot(...s.snapshot.force)");
  let isSeen = false, isSentOnly = false;
  for (let attempt = 0; attempt < 3 && !isSeen && await pressDown(page); ++attempt) {
    isSentOnly = true;  // unless the page that holds stops pressing, too
    for (const end = Date.now() + 3000; Date.now() < end && !isSeen;) {
      isSeen = await newtons(watcher.page) > 0.1;
      isSentOnly = isSentOnly && await newtons(page) > 0.1;
    }
  }
  if (!isSeen) {
    assert.ok(!isSentOnly, "one page hears of force and the other does not");
    t.skip(TOO_SLOW);
    return;
  }
  await page.goto("about:blank");
  await watcher.page.waitForFunction(() => Math.hypot(...window.thigma.session.snapshot.force) === 0, null, { polling: 50 });
  await watcher.context.close();
  await page.goto(run.address);
});
