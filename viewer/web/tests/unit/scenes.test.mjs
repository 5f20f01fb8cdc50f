import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { SCENE_FACTS } from "../../src/scenefacts.js";
import { SCENES_WITH_WORDS } from "../../src/scenes.js";

test("every scene with words has its picture and its size", () => {
  assert.deepEqual(Object.keys(SCENE_FACTS), SCENES_WITH_WORDS);
  const file = readFileSync(join(dirname(fileURLToPath(import.meta.url)), "../../src/scenes.webp"));
  const at = file.indexOf("VP8X") + 12; // canvas, each side less 1
  assert.deepEqual([1 + file.readUIntLE(at, 3), 1 + file.readUIntLE(at + 3, 3)], [144, 96 * SCENES_WITH_WORDS.length]);
  assert.ok(file.length < 40000, "small");
});
