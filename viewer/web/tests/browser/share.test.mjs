// From two scans to one file that somebody else opens: the page in Chromium and the program, THIGMA_PROGRAM (ctest sets it).
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { startProgram } from "../program.mjs";
import { openPage, startBrowser } from "./browser.mjs";

const program = process.env.THIGMA_PROGRAM;
const here = dirname(fileURLToPath(import.meta.url));
const READER = join(here, "../../../../tests/mcap_reader");
const PATIENCE = { timeout: 400000 };
let browser = null, reason = null, folder = null;

before(async () => {
  if (!program || !existsSync(program)) reason = "no program to run (THIGMA_PROGRAM is not set or not there)";
  else ({ browser, reason } = await startBrowser());
  folder = mkdtempSync(join(tmpdir(), "thigma-share-"));
});
after(async () => {
  await browser?.close();
  if (folder) rmSync(folder, { recursive: true, force: true });
});

/// A ball as a scanner would give it [mm], its triangles divided so often, with ripples as deep.
function scan(radius, divisions, ripple) {
  let points = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
  let faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
  for (let k = 0; k < divisions; k++) {
    const middles = new Map();
    const middle = (a, b) => {
      const key = `${Math.min(a, b)} ${Math.max(a, b)}`;
      if (!middles.has(key)) {
        const p = points[a].map((value, i) => value + points[b][i]), size = Math.hypot(...p);
        middles.set(key, points.push(p.map((value) => value / size)) - 1);
      }
      return middles.get(key);
    };
    faces = faces.flatMap(([a, b, c]) => {
      const [x, y, z] = [middle(a, b), middle(b, c), middle(c, a)];
      return [[a, x, z], [x, b, y], [z, y, c], [x, y, z]];
    });
  }
  points = points.map(([x, y, z]) => { const r = radius + ripple * Math.sin(24 * x) * Math.sin(24 * y) * Math.sin(24 * z); return [r * x, r * y, r * z]; });
  return { points, faces };
}
const toObj = ({ points, faces }) => `${points.map((p) => `v ${p.join(" ")}`).join("\n")}\n${faces.map((f) => `f ${f.map((v) => v + 1).join(" ")}`).join("\n")}\n`;
function toStl({ points, faces }) {
  const bytes = Buffer.alloc(84 + 50 * faces.length);
  bytes.writeUInt32LE(faces.length, 80);
  faces.forEach((face, k) => face.forEach((v, i) => points[v].forEach((value, axis) => bytes.writeFloatLE(value, 84 + 50 * k + 12 + 12 * i + 4 * axis))));
  return bytes;
}

const drop = async (page, files) => {
  const dropped = await page.evaluateHandle((all) => {
    const data = new DataTransfer();
    for (const { name, base64 } of all) data.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], name));
    return data;
  }, files.map((path) => ({ name: path.split("/").pop(), base64: readFileSync(path).toString("base64") })));
  await page.dispatchEvent("#scene", "drop", { dataTransfer: dropped });
};
/// Waits until the program runs a scene of which holds(objects).
async function settled(page, holds) {
  for (const end = Date.now() + 150000; Date.now() < end;) {
    const objects = await page.evaluate(() => { const { builder, session, stage } = window.thigma;
      return !builder.busy && stage.object && session.snapshot ? builder.composition.objects : null; });
    if (objects && holds(objects)) return;
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  assert.fail(`never: ${holds}`);
}

/// Two scans come on the page, one in the hand, the other with relief and friction, beside nothing else; saved as `name`.
async function putTogether(page, files, name) {
  await page.getByRole("tab", { name: "Scene" }).click();
  await drop(page, files);
  await settled(page, (o) => o.length === 4);
  const choose = (label) => page.getByRole("option", { name: label }).click();
  await choose(/^stone/);
  await page.getByRole("button", { name: "Take it in the hand" }).click();
  await settled(page, (o) => o.length === 4 && o[0].name === "stone");
  for (const left of [3, 2]) { // what was there
    await page.locator("#build [role=option]").nth(1).click();
    await page.getByRole("button", { name: "Remove" }).click();
    await settled(page, (o) => o.length === left);
  }
  const set = async (label, value, holds) => {
    await page.locator("#build").getByLabel(label, { exact: true }).fill(value);
    await page.locator("#build").getByLabel(label, { exact: true }).press("Enter");
    await settled(page, holds);
  };
  await choose(/^stone/);
  for (const [axis, value, k] of [["x", "0", 0], ["y", "0", 1], ["z", "33", 2]]) await set(`position ${axis}, mm`, value, (o) => Math.abs(o[0].position[k] - Number(value) / 1000) < 1e-9);
  await set("density, kg/m³", "1300", (o) => o[0].density === 1300);
  await choose(/^relief/);
  for (const [axis, k] of [["x", 0], ["y", 1], ["z", 2]]) await set(`position ${axis}, mm`, "0", (o) => Math.abs(o[1].position[k]) < 1e-9);
  await set("turned about z, degrees", "30", (o) => Math.abs(o[1].quaternion[2]) > 0.2);
  await set("friction", "0.35", (o) => o[1].friction === 0.35);
  await page.getByLabel("Name to save it under").fill(name);
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.getByText(new RegExp(`Saved: .*${name}\\.toml`)).waitFor();
}

test("two scans with poses, friction and relief: put together, saved, run, recorded, sent as one file, shown and read elsewhere", PATIENCE, async (t) => {
  if (reason) { t.skip(reason); return; }
  const at = (name) => join(folder, name);
  const say = (args, options = {}) => JSON.parse(execFileSync(program, args, { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"], ...options }).trim().split("\n").pop());
  writeFileSync(at("stone.stl"), toStl(scan(15, 3, 0)));
  writeFileSync(at("fine.obj"), toObj(scan(15, 5, 0.15)));
  writeFileSync(at("coarse.obj"), toObj(scan(15, 2, 0)));
  execFileSync(program, ["bake", at("fine.obj"), "--onto", at("coarse.obj"), "--scale", "0.001", "--texels", "256", "-o", at("relief.tex"), "--quiet"], { stdio: "ignore" });
  const run = await startProgram(program, [join(here, "small.toml"), "--exact", "--device", "hand:"]);
  const { page, errors, context } = await openPage(browser, run.address);
  page.setDefaultTimeout(60000);
  try {
    await page.waitForFunction(() => window.thigma?.session.counts.snapshot > 5 && window.thigma.stage.object && window.thigma.drawn > 0);
    await putTogether(page, [at("stone.stl"), at("relief.tex")], "two scans");
    assert.deepEqual(errors, []);
    mkdirSync(at("saved"));
    const kept = join(run.folder, "thigma/scenes");
    execFileSync("cp", ["-r", ...readdirSync(kept).map((name) => join(kept, name)), at("saved")]);
  } finally {
    await context.close();
    await run.end();
  }
  // Saved, it runs where the dropped files are not any more.
  for (const name of ["stone.stl", "relief.tex", "fine.obj", "coarse.obj"]) rmSync(at(name));
  const session = say(["run", at("saved/two scans.toml"), "--headless", "--lockstep", "--duration", "2", "--record", at("session.mcap"), "--json", "--quiet"]);
  assert.equal(session.haptic.frames, 2000);
  // One file alone in an empty folder: replayed bit by bit, run again, shown.
  rmSync(at("saved"), { recursive: true });
  mkdirSync(at("empty"));
  copyFileSync(at("session.mcap"), at("empty/session.mcap"));
  rmSync(at("session.mcap"));
  const elsewhere = { cwd: at("empty"), env: { ...process.env, XDG_DATA_HOME: at("empty"), XDG_CACHE_HOME: at("empty") } };
  const replay = say(["replay", "session.mcap", "--json"], elsewhere);
  assert.ok(replay.identical && replay.frames === 2000, JSON.stringify(replay));
  const again = say(["run", "session.mcap", "--headless", "--lockstep", "--duration", "2", "--json", "--quiet"], elsewhere);
  assert.equal(again.state_hash, session.state_hash, "the scene that travelled gives the same bits");
  await showElsewhere(at("empty/session.mcap"));
  readByFoxglove(t, at("empty/session.mcap"));
});

/// Dropped on a page of another scene, it is shown with its own surfaces.
async function showElsewhere(file) {
  const run = await startProgram(program, [join(here, "small.toml"), "--exact", "--device", "hand:"]);
  const { page, errors, context } = await openPage(browser, run.address);
  page.setDefaultTimeout(60000);
  try {
    await page.waitForFunction(() => window.thigma?.session.counts.snapshot > 5 && window.thigma.stage.object);
    await drop(page, [file]);
    await page.waitForFunction(() => window.thigma.session.state.replay && window.thigma.session.scene.object.name === "stone" && window.thigma.stage.object);
    const { object, statics } = await page.evaluate(() => window.thigma.session.scene);
    assert.deepEqual([object.triangles, statics.length, statics[0].name, statics[0].friction], [512, 1, "relief", 0.35]);
    assert.ok(statics[0].relief > 1e-4, "its relief is felt and drawn");
    await page.waitForFunction(() => window.thigma.session.snapshot?.contacts.length > 0 || Math.hypot(...(window.thigma.session.snapshot?.force ?? [0])) > 0.1);
    assert.deepEqual(errors, []);
  } finally {
    await context.close();
    await run.end();
  }
}

/// By the official reader: every checksum, the files in it, and pictures in Foxglove's own schemas.
function readByFoxglove(t, file) {
  if (!existsSync(join(READER, "node_modules"))) { t.diagnostic("the official reader is not installed (npm ci in tests/mcap_reader)"); return; }
  const read = JSON.parse(execFileSync(process.execPath, [join(READER, "read.mjs"), file], { encoding: "utf8", maxBuffer: 1 << 28 }));
  assert.deepEqual(Object.keys(read.attachments).sort(), ["assets/relief.tex", "assets/stone.stl", "scene.toml"]);
  const [transform] = read.first["/tf"].transforms;
  assert.ok(transform.parent_frame_id === "world" && Number.isFinite(transform.translation.z) && Number.isFinite(transform.rotation.w));
  const [entity] = read.first["/scene"].entities;
  assert.ok(entity.frame_id && entity.triangles[0].points.length > 0 && Number.isFinite(entity.triangles[0].points[0].x), JSON.stringify(entity).slice(0, 300));
}
