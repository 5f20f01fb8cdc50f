// node tests/browser/thumbs.mjs PROGRAM [SCENE...]: pictures of the scenes of the program for the list on the page, src/scenes.webp,
// one below the other, and what is said of their size, src/scenefacts.js. Made anew when a scene or the look of the page changes.
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { startProgram } from "../program.mjs";
import { openPage, startBrowser } from "./browser.mjs";

const here = dirname(fileURLToPath(import.meta.url)), src = join(here, "../../src");
const WIDE = 144, TALL = 96;
const [program, ...asked] = process.argv.slice(2);
const names = asked.length > 0 ? asked : [...readFileSync(join(src, "scenes.js"), "utf8").matchAll(/^ {2}([a-z_]+):/gm)].map(([, name]) => name);
const { browser, reason } = await startBrowser();
if (!browser) { console.error(reason); process.exit(3); }
const pictures = [], facts = {};
for (const name of names) {
  const run = await startProgram(program, [name, "--exact", "--device", "null:"]);
  const { page, context } = await openPage(browser, `${run.address}/?picture=full`, { viewport: { width: 900, height: 620 } });
  page.setDefaultTimeout(600000);
  await page.waitForFunction(() => window.thigma?.stage?.object && window.thigma.drawn > 2);
  await page.evaluate(() => { const { stage } = window.thigma; stage.view.distance = 3.1; stage.ground.visible = false; stage.view.changed = true; });
  pictures.push(await page.evaluate(([wide, tall]) => {
    const { stage } = window.thigma, { renderer, scene, view } = stage, canvas = stage.canvas;
    view.camera.updateProjectionMatrix();
    for (const { group } of [stage.ghost, stage.marks, stage.force, stage.twist, stage.spring, stage.rows]) group.visible = false;
    renderer.render(scene, view.camera);
    const small = Object.assign(document.createElement("canvas"), { width: wide, height: tall }), scale = Math.max(wide / canvas.width, tall / canvas.height);
    small.getContext("2d").drawImage(canvas, (wide - scale * canvas.width) / 2, (tall - scale * canvas.height) / 2, scale * canvas.width, scale * canvas.height);
    return small.toDataURL("image/png");
  }, [WIDE, TALL]));
  const { object, statics } = await page.evaluate(() => window.thigma.session.scene);
  facts[name] = { size: Number((2 * object.radius).toPrecision(2)), triangles: [object, ...statics].reduce((sum, { triangles }) => sum + triangles, 0) };
  await context.close();
  await run.end();
  console.log(name, facts[name]);
}
const { page } = await openPage(browser, "about:blank");
const sprite = await page.evaluate(async ([all, wide, tall]) => {
  const canvas = Object.assign(document.createElement("canvas"), { width: wide, height: tall * all.length }), context = canvas.getContext("2d");
  for (const [k, url] of all.entries()) {
    const image = new Image();
    image.src = url;
    await image.decode();
    context.drawImage(image, 0, tall * k);
  }
  return canvas.toDataURL("image/webp", 0.82);
}, [pictures, WIDE, TALL]);
await browser.close();
writeFileSync(join(src, "scenes.webp"), Buffer.from(sprite.split(",")[1], "base64"));
writeFileSync(join(src, "scenefacts.js"), `// Made by tests/browser/thumbs.mjs: the scenes in the order of their pictures in scenes.webp; size: of the object in the hand [m].
export const SCENE_FACTS = ${JSON.stringify(facts, null, 2).replace(/\n {4}/g, " ").replace(/\n {2}\}/g, " }")};\n`);
