// dist/ is what src/ bundles to, byte for byte; and the page stays one script and its two workers that ask nobody else for anything.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "../..");

test("dist is what src bundles to", { timeout: 300000 }, async (t) => {
  if (!existsSync(join(root, "node_modules/esbuild"))) { t.skip("esbuild is not installed (npm ci in viewer/web)"); return; }
  const { code, stderr } = await new Promise((resolve) =>
    execFile(process.execPath, ["build.mjs", "--check"], { cwd: root }, (error, _, text) => resolve({ code: error?.code ?? 0, stderr: text })));
  assert.equal(code, 0, stderr);
});

test("dist is whole, with one script and its two workers and nothing inline", () => {
  assert.deepEqual(readdirSync(join(root, "dist")).sort(), ["LICENSES.txt", "app.js", "coarsener.js", "icon.svg", "index.html", "scenes.webp", "style.css", "worker.js"]);
  const html = readFileSync(join(root, "dist/index.html"), "utf8");
  assert.deepEqual([...html.matchAll(/<script[^>]*>/g)].map(([tag]) => tag), ['<script src="app.js">']);
  for (const worker of ["worker", "coarsener"]) {
    assert.match(readFileSync(join(root, "dist/app.js"), "utf8"), new RegExp(`new Worker\\("${worker}\\.js"\\)`));
    assert.doesNotMatch(readFileSync(join(root, `dist/${worker}.js`), "utf8"), /importScripts|https?:/);
  }
  assert.doesNotMatch(html, /\son\w+=|\sstyle=|https?:/);
  assert.doesNotMatch(readFileSync(join(root, "dist/style.css"), "utf8"), /url\((?!scenes\.webp\))|@import|https?:/);
});
