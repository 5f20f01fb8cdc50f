// `thigma run` with its page as a process, for tests.
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../..");

/// In a folder of its own, where it keeps what it writes for its user, too; `more` of its environment; {address, folder, port, child, memory(): resident [bytes], end(): exit status}.
export async function startProgram(program, args, more = {}) {
  const folder = mkdtempSync(join(tmpdir(), "thigma-page-"));
  const child = spawn(program, ["run", ...args.map((text) => text.replace("SCENES", join(root, "scenes"))), "--port", "0"],
    { cwd: folder, env: { ...process.env, XDG_DATA_HOME: folder, ...more }, stdio: ["ignore", "pipe", "pipe"] });
  let said = "";
  const ended = new Promise((resolve) => child.on("exit", (code, signal) => resolve(code ?? signal)));
  const address = await new Promise((resolve, reject) => {
    const hear = (data) => {
      said = (said + data).slice(-4000);
      const found = /http:\/\/127\.0\.0\.1:\d+(?=[\s/])/.exec(said);
      if (found) resolve(found[0]);
    };
    child.stdout.on("data", hear);
    child.stderr.on("data", hear);
    ended.then((code) => reject(new Error(`thigma run ended with ${code}: ${said.slice(-400)}`)));
  });
  return { address, folder, port: Number(new URL(address).port), child,
    memory: () => 1024 * Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${child.pid}/status`, "utf8"))?.[1] ?? NaN),
    end: async () => {
      child.kill("SIGINT");
      const code = await ended;
      rmSync(folder, { recursive: true, force: true });
      return code;
    } };
}
