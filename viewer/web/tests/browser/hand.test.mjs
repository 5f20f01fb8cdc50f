// The page's hand: mouse, finger, gamepad; what reaches the program, and when.
import assert from "node:assert/strict";
import { until } from "./browser.mjs";
import { drag, drawnSince, pageTest } from "./page_test.mjs";

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
