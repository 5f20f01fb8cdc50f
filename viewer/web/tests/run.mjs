// node tests/run.mjs REPORT.xml FOLDER: the tests of a folder, one file after the other; what happened goes to the terminal
// and, as GoogleTest writes it, to REPORT.xml. Exit status 1 when one fails.
import { mkdirSync, readdirSync, writeFileSync } from "node:fs";
import { basename, dirname, join, resolve } from "node:path";
import { run } from "node:test";

const [report, folder] = process.argv.slice(2);
const files = readdirSync(folder).filter((name) => name.endsWith(".test.mjs")).sort().map((name) => resolve(join(folder, name)));
const suite = basename(report, ".xml");
const escape = (text) => String(text).replace(/[&<>"\n]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "\n": "&#10;" })[c]);
const cases = [];
let failed = 0;

function note(result, data) {
  const name = data.name.replace(/\s+/g, " ");
  if (files.some((file) => file === data.name || data.name.endsWith(basename(file)))) {
    if (result !== "fail") return; // a file that ran: its cases speak for it
  }
  const reason = typeof data.skip === "string" ? data.skip : "no reason given";
  const error = data.details?.error;
  const body = result === "fail" ? `<failure message="${escape(error?.cause?.message ?? error?.message ?? "failed")}"/>`
    : result === "skip" ? `<skipped message="${escape(reason)}"/>` : "";
  cases.push(`<testcase name="${escape(name)}" classname="${suite}" status="run" time="${(data.details?.duration_ms ?? 0) / 1000}">${body}</testcase>`);
  console.log(`${{ pass: "ok     ", fail: "FAILED ", skip: "skipped" }[result]} ${name}${result === "skip" ? `: ${reason}` : ""}`);
  if (result !== "fail") return;
  failed += 1;
  console.log(error?.cause?.stack ?? error?.stack ?? error);
}

const stream = run({ files, concurrency: 1 });
stream.on("test:pass", (data) => note(data.skip !== undefined ? "skip" : "pass", data));
stream.on("test:fail", (data) => note("fail", data));
stream.on("end", () => {
  mkdirSync(dirname(report), { recursive: true });
  writeFileSync(report, `<?xml version="1.0" encoding="UTF-8"?>\n<testsuites><testsuite name="${suite}">\n${cases.join("\n")}\n</testsuite></testsuites>\n`);
  process.exit(failed > 0 || cases.length === 0 ? 1 : 0);
});
stream.resume();
