// What the page asks the program for, and what it does where the program does not answer.
import assert from "node:assert/strict";
import { until } from "./browser.mjs";
import { drag, pageTest } from "./page_test.mjs";

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

pageTest("nothing comes from elsewhere", {}, async ({ mock, hosts }) => {
  assert.deepEqual([...hosts], [`127.0.0.1:${mock.port}`]);
});
