// node build.mjs [--check]: bundles src/ into dist/, or compares what a bundle would be with the committed one.
// The program embeds dist/, so nobody needs Node to run it.
import { readFile, writeFile, mkdir } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));

async function bundle(entry, options) {
  const made = await build({
    absWorkingDir: here,
    entryPoints: [entry],
    bundle: true,
    minify: true,
    write: false,
    outfile: "out",
    target: ["es2022"],
    charset: "utf8",
    legalComments: "none", // dist/LICENSES.txt has them whole
    logLevel: "error",
    ...options,
  });
  return Buffer.from(made.outputFiles[0].contents);
}

async function licences() {
  const parts = ["The page contains these libraries.\n"];
  for (const name of ["three", "uplot"]) {
    const folder = join(here, "node_modules", name);
    const { version } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
    parts.push(`${name} ${version}\n\n${(await readFile(join(folder, "LICENSE"), "utf8")).replaceAll("\r\n", "\n")}`);
  }
  return Buffer.from(parts.join("\n----------------------------------------------------------------\n"));
}

const files = {
  "app.js": await bundle("src/main.js", { format: "iife" }),
  "worker.js": await bundle("src/worker.js", { format: "iife" }),
  "coarsener.js": await bundle("src/coarsener.js", { format: "iife" }),
  "style.css": await bundle("src/style.css", { external: ["scenes.webp"] }),
  "index.html": await readFile(join(here, "src/index.html")),
  "icon.svg": await readFile(join(here, "src/icon.svg")),
  "scenes.webp": await readFile(join(here, "src/scenes.webp")),
  "LICENSES.txt": await licences(),
};

const dist = join(here, "dist");
let different = 0;
if (process.argv.includes("--check")) {
  for (const [name, bytes] of Object.entries(files)) {
    const committed = await readFile(join(dist, name)).catch(() => null);
    if (committed && committed.equals(bytes)) continue;
    different += 1;
    console.error(`viewer/web/dist/${name}: is not what src/ bundles to; run npm run build in viewer/web`);
  }
} else {
  await mkdir(dist, { recursive: true });
  for (const [name, bytes] of Object.entries(files)) await writeFile(join(dist, name), bytes);
  console.log(Object.entries(files).map(([name, bytes]) => `${name} ${bytes.length}`).join("\n"));
}
process.exit(different ? 1 : 0);
