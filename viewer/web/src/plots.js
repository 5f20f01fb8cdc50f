// The scrolling plots: one small uPlot each, all over the same seconds.
import uPlot from "uplot";
import { clearHistory, makeHistory, push, toCsv, view } from "./history.js";
import { say, split } from "./format.js";
import { colour, currentTheme } from "./theme.js";

export const SECONDS = 10;
const HEIGHT = 56; // of a plot, as in style.css [px]
const BETWEEN = 45; // from one drawing to the next, three frames of a screen [ms]
const FAST = ["force", "force_x", "force_y", "force_z", "torque", "torque_x", "torque_y", "torque_z", "penetration",
  "stretch", "energy", "model_age", "step_cpu", "wake_late"];
const SLOW = ["haptic_rate", "contact_rate"];
const AXES = ["x", "y", "z"];

/// What is drawn: the first line is the strong one, its newest value stands in the head.
const PLOTS = [
  { id: "force", title: "Force on the hand", unit: "N", least: 1e-3, lines: ["force", "force_x", "force_y", "force_z"],
    names: ["size", ...AXES], colours: ["force", "x", "y", "z"] },
  { id: "torque", title: "Torque on the hand", unit: "N m", least: 1e-6, lines: ["torque", "torque_x", "torque_y", "torque_z"],
    names: ["size", ...AXES], colours: ["torque", "x", "y", "z"] },
  { id: "penetration", title: "Penetration, below 0: gap", unit: "m", least: 1e-9, lines: ["penetration"], names: ["depth"],
    colours: ["contact"] },
  { id: "stretch", title: "Coupling stretch", unit: "m", least: 1e-9, lines: ["stretch"], names: ["stretch"], colours: ["hand"] },
  { id: "rates", title: "Contact and haptic rate", unit: "Hz", least: 1, lines: ["contact_rate", "haptic_rate"],
    names: ["contact", "haptic"], colours: ["contact", "held"], slow: true },
  { id: "age", title: "Age of the contact model", unit: "s", least: 1e-6, lines: ["model_age"], names: ["age"], colours: ["muted"] },
  { id: "energy", title: "Energy put in by the hand", unit: "J", least: 1e-9, lines: ["energy"], names: ["energy"], colours: ["torque"] },
];

/// saves   [[name, help, act]]: buttons above the plots; pick(time): a time was chosen
export function makePlots(parent, saves, pick) {
  const board = { pick, pointed: null, parent, fast: makeHistory(FAST, SECONDS), slow: makeHistory(SLOW, SECONDS, 600), plots: [], rows: 0,
    now: 0, marks: [], theme: null, floors: { Hz: 1000, s: 1e-3 }, rested: 0 };
  const top = Object.assign(document.createElement("div"), { className: "plots-head" });
  board.moment = Object.assign(document.createElement("span"), { className: "grow moment" });
  top.append(board.moment);
  for (const [name, help, act] of saves) {
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: name, title: help });
    button.setAttribute("aria-label", `${name}: ${help}`);
    button.addEventListener("click", act);
    top.append(button);
  }
  parent.append(top);
  parent.addEventListener("keydown", (event) => moveCursor(board, event));
  for (const spec of PLOTS) {
    const box = document.createElement("figure");
    box.className = "plot";
    const head = document.createElement("figcaption");
    const value = document.createElement("output");
    const keys = document.createElement("span");
    keys.className = "keys";
    head.append(Object.assign(document.createElement("span"), { textContent: spec.title, className: "plot-title" }), keys, value);
    const area = document.createElement("div");
    area.className = "plot-area";
    box.append(head, area);
    parent.append(box);
    board.plots.push({ spec, box, area, keys, value, chart: null });
  }
  return board;
}

/// Again with the colours of the theme, and as wide as there is room.
export function rebuildPlots(board) {
  board.theme = currentTheme();
  for (const plot of board.plots) {
    plot.chart?.destroy();
    plot.keys.replaceChildren(...(plot.spec.lines.length > 1 ? plot.spec.names.map((name, k) => {
      const key = Object.assign(document.createElement("i"), { textContent: name });
      key.style.setProperty("--tone", colour(plot.spec.colours[k]));
      return key;
    }) : []));
    const width = plot.area.clientWidth || 300;
    plot.chart = new uPlot(options(board, plot, width), view(historyOf(board, plot), plot.spec.lines), plot.area);
    plot.chart.over.addEventListener("click", () => { if (board.pointed) board.pick(board.pointed.time); });
  }
}

const historyOf = (board, { spec }) => (spec.slow ? board.slow : board.fast);

function options(board, { spec }, width) {
  const grid = { stroke: colour("grid"), width: 1 };
  const font = "10px system-ui, sans-serif";
  return {
    width, height: HEIGHT, legend: { show: false }, cursor: { sync: { key: "thigma" }, points: { size: 5 }, drag: { x: false, y: false } },
    padding: [6, 6, 0, 0],
    scales: { x: { time: false, range: () => [board.now - SECONDS, board.now] },
      y: { range: (u, low, high) => spread(low, high, Math.max(spec.least, board.floors[spec.unit] ?? 0)) } },
    axes: [
      { show: true, size: 4, grid, ticks: { show: false }, values: () => [], space: 40 },
      { size: 52, grid, ticks: { show: false }, space: 12, gap: 4, font, stroke: colour("muted"),
        values: (u, at) => labels(at, spec) },
    ],
    series: [{}, ...spec.lines.map((name, k) => ({ stroke: colour(spec.colours[k]), width: k === 0 || spec.slow ? 1.6 : 0.8,
      alpha: k === 0 || spec.slow ? 1 : 0.75, points: { show: false }, spanGaps: false,
      fill: k === 0 && !spec.slow ? `${colour(spec.colours[k])}1f` : undefined }))],
    hooks: { draw: [(u) => drawMarks(u, board)] },
  };
}

/// Room around what is there; never so tight that noise fills the height.
/// floor   least span shown
function spread(low, high, floor) {
  if (!Number.isFinite(low) || !Number.isFinite(high)) return [0, floor];
  const bottom = Math.min(0, low), top = Math.max(0, high, bottom + floor);
  const room = 0.1 * (top - bottom);
  return [bottom < 0 ? bottom - room : 0, top + room];
}

/// One prefix for the whole axis; the unit stands at its top. Every other line is labelled where they are close.
function labels(at, spec) {
  const largest = Math.max(...at.map(Math.abs));
  const { number: shown, unit } = split(largest, spec.unit, spec.least);
  const scale = largest === 0 ? 1 : Number(shown) / largest;
  const every = at.length > 3 ? 2 : 1;
  const top = at.length - 1 - ((at.length - 1) % every);
  return at.map((value, k) => {
    if (k % every !== 0) return null;
    const number = Number((value * scale).toPrecision(2)).toString();
    return k === top ? `${number} ${unit}` : number;
  });
}

/// Upright lines where something happened.
function drawMarks(u, board) {
  const { ctx, bbox } = u;
  ctx.save();
  ctx.lineWidth = 1;
  ctx.setLineDash([3, 3]);
  for (const { time, kind } of board.marks) {
    if (time < board.now - SECONDS) continue;
    const x = u.valToPos(time, "x", true);
    ctx.strokeStyle = colour(kind === "fault" ? "bad" : "mark");
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
  }
  ctx.restore();
}

export function addMark(board, time, kind) {
  board.marks.push({ time, kind });
  board.marks = board.marks.filter((mark) => mark.time > time - SECONDS).slice(-40);
}

/// Least spans of the axes, from the size of the scene: how long a newton is drawn says how strong forces are.
/// radius, tolerance, perNewton [m]
export function setFloors(board, radius, tolerance, perNewton) {
  const newtons = radius / perNewton / 10;
  Object.assign(board.floors, { N: newtons, "N m": 0.3 * newtons * radius, m: 0.25 * tolerance, J: 0.01 * newtons * radius });
}

/// message   decoded `channels`; names as in hello
export function addRows(board, message, names) {
  const at = Object.fromEntries(names.map((name, k) => [name, k]));
  const wanted = FAST.filter((name) => at[name] !== undefined);
  for (let row = 0; row < message.rows; row++) {
    const cell = (name) => message.values[row * message.columns + at[name]];
    const sample = Object.fromEntries(wanted.map((name) => [name, cell(name)]));
    sample.force = Math.hypot(sample.force_x, sample.force_y, sample.force_z);
    sample.torque = Math.hypot(sample.torque_x, sample.torque_y, sample.torque_z);
    const time = message.time + cell("t");
    push(board.fast, time, sample);
  }
  board.rows += message.rows;
}

export function addRates(board, time, haptic, contact) {
  push(board.slow, time, { haptic_rate: haptic, contact_rate: contact });
}

export function clearPlots(board) {
  clearHistory(board.fast);
  clearHistory(board.slow);
  board.marks = [];
}

const CURSOR_STEP = 1 / 40; // of the width, of an arrow key

/// The time cursor by keys: it stays where it is put until Escape.
function moveCursor(board, event) {
  const way = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  if ((!way && event.key !== "Escape" && event.key !== "Enter") || event.target !== board.parent) return;
  if (event.key === "Enter") { if (board.pointed) board.pick(board.pointed.time); return; }
  event.preventDefault();
  for (const { chart } of board.plots) {
    const width = chart.over.clientWidth, at = chart.cursor.left >= 0 ? chart.cursor.left : width;
    const left = way ? Math.max(0, Math.min(width - 1, at + way * CURSOR_STEP * width)) : -10;
    chart.setCursor({ left, top: left < 0 ? -10 : 0.5 * HEIGHT }, false, false);
  }
  board.rested = 0;
}

/// What was felt where the time cursor is, null where it is nowhere.
function pointedAt(board) {
  const { chart } = board.plots[0], { idx, left } = chart.cursor;
  if (idx === null || idx === undefined || !(left >= 0) || !(idx < board.fast.used)) return null;
  const value = (name) => board.fast.values[name][idx];
  return { time: board.fast.times[idx], force: value("force"), torque: value("torque"), penetration: value("penetration"), stretch: value("stretch") };
}

const RASTER = 2; // where the processor draws: times as long again until the lines are on the screen as it takes to say them

/// Twenty times a second at most, and for a tenth of the time at most.
/// now     of what else is shown [s]: nothing after it is
/// plain   the processor draws
export function drawPlots(board, now, plain = false) {
  const begin = performance.now();
  if (begin < board.rested || board.parent.hidden || board.parent.offsetParent === null) return;
  Object.assign(board, { now, pointed: pointedAt(board) });
  const words = board.pointed ? `At ${board.pointed.time.toFixed(2)} s, ${(now - board.pointed.time).toFixed(2)} s ago`
    : `The last ${SECONDS} s; point at a time to read it`;
  if (board.moment.textContent !== words) board.moment.textContent = words;
  if (board.theme !== currentTheme()) rebuildPlots(board);
  let said = begin; // the charts put off their lines until all else of this turn is done
  queueMicrotask(() => { said = performance.now(); });
  for (const plot of board.plots) {
    const data = view(historyOf(board, plot), plot.spec.lines);
    const width = plot.area.clientWidth;
    if (width > 0 && width !== plot.chart.width) plot.chart.setSize({ width, height: HEIGHT });
    plot.chart.setData(data);
    const at = readAt(board, plot, data);
    plot.value.textContent = say(at(0), plot.spec.unit, plot.spec.least);
    [...plot.keys.children].forEach((key, k) => {
      const text = board.pointed ? `${plot.spec.names[k]} ${say(at(k), plot.spec.unit, plot.spec.least)}` : plot.spec.names[k];
      if (key.textContent !== text) key.textContent = text;
    });
  }
  const spent = performance.now() - begin;
  board.rested = Infinity;
  queueMicrotask(() => {
    const end = performance.now(), cost = (1 + (plain ? RASTER : 0)) * (spent + end - said);
    board.rested = end + Math.max(BETWEEN, 9 * cost);
  });
}

/// (line) -> its value under the cursor, or at the time that is shown.
function readAt(board, { chart }, data) {
  let at = chart.cursor.left >= 0 ? chart.cursor.idx : null;
  if (at === null || at === undefined) for (at = data[0].length - 1; at > 0 && data[0][at] > board.now;) at -= 1;
  return (line) => (at >= 0 ? data[1 + line][at] ?? NaN : NaN);
}

/// All plots as one picture.
export function plotPicture(board, title) {
  const ratio = devicePixelRatio || 1;
  const charts = board.plots.map(({ spec, chart }) => ({ spec, canvas: chart.root.querySelector("canvas") }));
  const width = charts[0].canvas.width, head = Math.round(22 * ratio), top = Math.round(34 * ratio);
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = top + charts.reduce((sum, { canvas: one }) => sum + head + one.height, 0) + head;
  const ctx = canvas.getContext("2d");
  ctx.fillStyle = colour("panel");
  ctx.fillRect(0, 0, canvas.width, canvas.height);
  ctx.fillStyle = colour("ink");
  ctx.font = `600 ${14 * ratio}px system-ui, sans-serif`;
  ctx.fillText(title, 10 * ratio, 22 * ratio);
  let y = top;
  ctx.font = `${12 * ratio}px system-ui, sans-serif`;
  for (const { spec, canvas: one } of charts) {
    ctx.fillText(spec.title, 10 * ratio, y + 15 * ratio);
    ctx.drawImage(one, 0, y + head);
    y += head + one.height;
  }
  return canvas;
}

export function plotTable(board) {
  return toCsv(board.fast, { force_x: "force x on the hand [N]", force_y: "force y on the hand [N]", force_z: "force z on the hand [N]",
    torque_x: "torque x on the hand [N m]", torque_y: "torque y on the hand [N m]", torque_z: "torque z on the hand [N m]",
    penetration: "penetration [m]", stretch: "coupling stretch [m]", energy: "energy put in by the hand [J]",
    model_age: "age of the contact model [s]" });
}
