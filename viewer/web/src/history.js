// What the plots show: the last seconds of every channel, in bins that keep the extremes, so that a spike of one
// millisecond stays visible at any width.

/// seconds   kept
/// bins      of that time; each holds the sample farthest from zero it saw
export function makeHistory(channels, seconds = 10, bins = 2500) {
  const step = seconds / bins;
  return { step, bins, used: 0, last: -1, base: null, times: new Float64Array(bins),
    values: Object.fromEntries(channels.map((name) => [name, new Float64Array(bins).fill(NaN)])) };
}

export function clearHistory(history) {
  history.used = 0;
  history.last = -1;
  history.base = null;
}

/// time     [s], rising; a time before the last one begins anew (the session was reset)
/// sample   {channel: number}; what is missing or not finite leaves a gap
export function push(history, time, sample) {
  if (!Number.isFinite(time)) return;
  if (history.base === null) history.base = time;
  let bin = Math.floor((time - history.base) / history.step);
  if (bin < history.last) {
    clearHistory(history);
    history.base = time;
    bin = 0;
  }
  const fresh = bin !== history.last;
  if (fresh) {
    if (history.used === history.bins) dropOldest(history);
    history.times[history.used] = time;
    for (const row of Object.values(history.values)) row[history.used] = NaN;
    history.used += 1;
    history.last = bin;
  }
  const at = history.used - 1;
  for (const [name, value] of Object.entries(sample)) {
    const row = history.values[name];
    if (!row || !Number.isFinite(value)) continue;
    if (!(Math.abs(row[at]) >= Math.abs(value))) row[at] = value;
  }
}

/// An eighth at once: moving memory for every sample would cost more than drawing it.
function dropOldest(history) {
  const drop = history.bins >> 3;
  history.times.copyWithin(0, drop);
  for (const row of Object.values(history.values)) row.copyWithin(0, drop);
  history.used -= drop;
}

/// The used part, for drawing: [times, ...channels]; null where there is a gap.
export function view(history, channels) {
  return [history.times.subarray(0, history.used), ...channels.map((name) => {
    const row = new Array(history.used);
    for (let k = 0; k < history.used; k++) row[k] = Number.isNaN(history.values[name][k]) ? null : history.values[name][k];
    return row;
  })];
}

/// Comma-separated text with a header; units stand in `labels`.
export function toCsv(history, labels) {
  const names = Object.keys(labels);
  const lines = [["time [s]", ...names.map((name) => labels[name])].join(",")];
  for (let k = 0; k < history.used; k++) {
    const row = names.map((name) => (Number.isFinite(history.values[name][k]) ? history.values[name][k] : ""));
    lines.push([history.times[k].toFixed(4), ...row].join(","));
  }
  return lines.join("\n") + "\n";
}
