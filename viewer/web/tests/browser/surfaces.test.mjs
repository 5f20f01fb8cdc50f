// Which surfaces are drawn: levels of detail, relief, what comes and goes with a scene.
import assert from "node:assert/strict";
import { drawnSince, pageTest } from "./page_test.mjs";

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
