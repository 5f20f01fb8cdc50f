// Processor time of processes and their threads, from /proc.
import { readdirSync, readFileSync } from "node:fs";

const TICK = 100; // of /proc a second
const read = (path) => { try { return readFileSync(path, "utf8"); } catch { return ""; } };
const list = (path) => { try { return readdirSync(path).filter((name) => /^\d+$/.test(name)); } catch { return []; } };

/// {parent, seconds}: of a process or a thread, by its folder; null where it is gone.
function timesOf(folder) {
  const text = read(`${folder}/stat`), fields = text.slice(text.lastIndexOf(")") + 2).split(" ");
  return fields.length > 12 ? { parent: fields[1], seconds: (Number(fields[11]) + Number(fields[12])) / TICK } : null;
}

/// CPU time of this process's descendants of one kind of Chromium's ("gpu-process", "renderer") [s].
export function cpuOf(kind) {
  const parents = new Map(), own = new Map();
  for (const pid of list("/proc")) {
    const times = timesOf(`/proc/${pid}`);
    if (!times) continue;
    parents.set(pid, times.parent);
    if (read(`/proc/${pid}/cmdline`).includes(`--type=${kind}`)) own.set(pid, times.seconds);
  }
  const isMine = (pid) => pid === String(process.pid) || (parents.has(pid) && isMine(parents.get(pid)));
  return [...own].filter(([pid]) => isMine(pid)).reduce((sum, [, seconds]) => sum + seconds, 0);
}

/// Follows the threads that a process begins from now on; the function it gives ends that and says the CPU time
/// of each [s], to a twentieth of a second of those that have ended, most first.
export function followNewThreads(pid) {
  const folder = `/proc/${pid}/task`, old = new Set(list(folder)), times = new Map();
  const look = () => { for (const id of list(folder)) if (!old.has(id)) times.set(id, timesOf(`${folder}/${id}`)?.seconds ?? times.get(id) ?? 0); };
  const timer = setInterval(look, 50);
  return () => {
    look();
    clearInterval(timer);
    return [...times.values()].sort((a, b) => b - a);
  };
}
