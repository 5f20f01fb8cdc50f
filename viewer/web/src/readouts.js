// The numbers that matter, in words and with units.
import { count, digits, say } from "./format.js";
import { STATE } from "./protocol.js";
import { atConeEdge, deciderWords, levelCounts, limitWords, rowSituation, situation, worldSituation } from "./words.js";
import { fullScales, sayIn, shareOf, steadyUnit } from "./steady.js";
import { LEVEL_COLOURS, levelColour } from "./theme.js";
import { element } from "./dom.js";

const TILES = [
  { id: "force", name: "Force", unit: "N", help: "on the hand, as sent to the device; the bar ends at the limit of device and safety" },
  { id: "torque", name: "Torque", unit: "N m", help: "on the hand, about the handle; the bar ends at the limit of device and safety" },
  { id: "penetration", name: "Depth", unit: "m",
    help: "of the deepest contact: how far the surfaces pass into each other, or the gap between them; forces begin before they touch; " +
      "the bar ends where the contact gives the largest force, or the tolerance" },
  { id: "stretch", name: "Stretch", unit: "m", help: "from the hand to where it holds the object: the spring that is felt; the bar ends at the limit of the force" },
];

export function makeReadouts(parent) {
  const board = { parent, tiles: {}, lines: {} };
  const tiles = element("div", "tiles");
  for (const { id, name, help } of TILES) {
    const tile = element("div", `tile ${id}`);
    tile.title = help;
    const number = element("span", "number"), unit = element("span", "unit");
    const title = element("span", "name", name), gauge = element("i", "gauge"), limit = element("span", "limit");
    tile.append(title, number, unit, gauge, limit);
    tiles.append(tile);
    board.tiles[id] = { tile, title, number, unit, gauge, limit };
  }
  const said = element("p", "situation");
  const lines = element("ul", "lines");
  for (const id of ["limit", "rows", "level", "loop", "contact", "energy"]) {
    const line = element("li", `line ${id}`), dot = element("i", "dot"), text = element("span");
    line.append(dot, text);
    lines.append(line);
    board.lines[id] = { line, text, dot };
  }
  parent.append(tiles, said, lines);
  board.said = said;
  return board;
}

const norm = (v) => Math.hypot(...v);

/// values   {force, torque, penetration, stretch} in SI units
function showTiles(board, values, full) {
  for (const { id, unit } of TILES) {
    const tile = board.tiles[id], steady = steadyUnit(full[id], unit), share = shareOf(values[id], full[id]);
    setText(tile.number, sayIn(id === "penetration" ? Math.abs(values[id]) : values[id], steady));
    setText(tile.unit, steady.unit);
    setText(tile.limit, `of ${Number((full[id] / steady.scale).toPrecision(2))}`);
    tile.gauge.style.setProperty("--share", share.toFixed(3));
    tile.tile.classList.toggle("full", share > 0.9);
  }
  setText(board.tiles.penetration.title, values.penetration < 0 ? "Gap" : "Depth");
}

function setText(target, text) {
  if (target.textContent !== text) target.textContent = text;
}

/// session   {shown: the snapshot in the picture, state, scene, bodies, parameters}, the newest messages; any but the last may be null
/// pointed   {time, force, torque, penetration, stretch} where the time cursor of the plots is, null: nowhere
export function showReadouts(board, { shown: snapshot, state, scene, bodies, parameters }, pointed = null) {
  if (!snapshot || !scene) return;
  const inside = snapshot.penetration > 0;
  showTiles(board, pointed ?? { force: norm(snapshot.force), torque: norm(snapshot.torque), stretch: snapshot.stretch,
    penetration: snapshot.penetration }, fullScales(state?.limits, parameters, scene));
  board.parent.classList.toggle("pointed", Boolean(pointed));
  showLoop(board.lines.loop, snapshot, state, scene);
  line(board.lines.energy, "", `The hand has put in ${say(snapshot.energy, "J", 1e-9)}.`);
  board.lines.level.line.hidden = board.lines.contact.line.hidden = Boolean(scene.world);
  if (scene.world) {
    board.said.textContent = worldSituation(scene, bodies);
    for (const id of ["limit", "rows"]) board.lines[id].line.hidden = true;
    return;
  }
  const touching = inside || norm(snapshot.contactForce) > 0;
  const facts = { object: scene.object.name, statics: scene.statics.map((one) => one.name), grasped: (snapshot.bits & 1) !== 0,
    armed: (snapshot.bits & 6) === 2, contacts: snapshot.contactsFound, clusters: snapshot.clusters.length, touching };
  const constrained = (snapshot.bits & STATE.constrained) !== 0;
  board.said.textContent = constrained ? constrainedSituation(board, facts, { snapshot, state, scene, parameters }) : situation(facts);
  for (const id of ["limit", "rows"]) board.lines[id].line.hidden = !constrained;
  showLevel(board.lines.level, snapshot, scene);
  showContact(board.lines.contact, snapshot, state);
}

/// The sentence of a session under constraints; the lines of what limits what and of the rows too.
function constrainedSituation(board, facts, { snapshot, state, scene, parameters }) {
  const pressing = snapshot.rows.filter(({ presses }) => presses).length;
  const stiffness = parameters.find(({ name }) => name === "coupling_stiffness")?.value ?? null;
  const counts = state?.constraint ?? null;
  const about = { pressing, stiffness, stretch: snapshot.stretch, force: norm(snapshot.force) / scene.workspace.force_scale,
    heldBack: counts?.held_back ?? 0, squeezed: counts?.squeezed ?? 0, say };
  line(board.lines.limit, about.heldBack > 0.01 || about.squeezed > 0.1 ? "warn" : "good", limitWords(about));
  line(board.lines.rows, counts?.left_out > 0 || counts?.halvings > 0 ? "warn" : "", rowWords(snapshot, counts));
  return rowSituation({ ...facts, rows: counts?.rows ?? snapshot.rows.length, pressing, newtons: say(norm(snapshot.force), "N", 1e-3),
    stiffness: stiffness === null ? null : say(stiffness, "N/m", 1) });
}

function rowWords({ rows }, counts) {
  if (!counts) return "Rows: not counted yet.";
  const parts = [`${count(counts.in_model, "row")} in the contact model`];
  if (counts.halvings > 0) parts.push(`more were needed than fit, so its travel was halved ${counts.halvings === 1 ? "once" : `${counts.halvings} times`}`);
  if (counts.left_out > 0) parts.push(`${count(counts.left_out, "contact")} had no room: nothing may move`);
  if (Number.isFinite(counts.travel) && counts.travel !== null) parts.push(`free for ${say(counts.travel, "m", 1e-6)} around`);
  const edge = atConeEdge(rows);
  if (edge > 0) parts.push(`${edge} at the edge of ${edge === 1 ? "its cone" : "their cones"}`);
  return `${parts.join("; ")}.`;
}

function line(target, mood, text) {
  target.line.dataset.mood = mood;
  if (target.text.textContent !== text) target.text.textContent = text;
}

function showLevel(target, snapshot, scene) {
  const counts = levelCounts(snapshot.contacts);
  const whole = scene.object.levels > 1 ? ` of ${scene.object.levels} levels` : "";
  let text = "Level of detail: none in use, as nothing is near.";
  const original = counts[0]?.[0] === 0 ? ", the original surface" : "";
  if (counts.length === 1) text = `Level of detail at the contacts: ${counts[0][0]}${whole}${original}.`;
  if (counts.length > 1) text = `Levels of detail at the contacts: ${counts.map(([level]) => level).join(", ")}${whole}; 0 is the finest.`;
  const deciders = deciderWords(snapshot.contacts);
  line(target, "", deciders ? `${text} Decided ${deciders}${deciders.includes("100 %") ? "" : "; there is nothing finer elsewhere"}.` : text);
  target.dot.style.background = counts.length > 0 ? levelColour(counts[0][0]) : "";
}

function showLoop(target, snapshot, state, scene) {
  const rate = snapshot.hapticRate, asked = scene.rate;
  if (state?.replay) return line(target, "", `A recording of a loop at ${Math.round(asked)} Hz.`);
  if (!Number.isFinite(rate)) return line(target, "", "Haptic loop: not measured yet.");
  if (state?.run !== "running") return line(target, "", `Haptic loop: ${state?.run ?? "unknown"}.`);
  const holds = rate >= 0.99 * asked;
  const missed = state?.timing?.missed ?? null;
  const tail = missed === null ? "" : `, ${count(missed, "frame")} missed`;
  return holds ? line(target, "good", `The loop holds ${Math.round(asked)} Hz${tail}.`)
    : line(target, "warn", `The loop runs at ${Math.round(rate)} of ${Math.round(asked)} Hz${tail}.`);
}

function showContact(target, snapshot, state) {
  if (state?.replay) {
    const old = Number.isFinite(snapshot.modelAge) ? ` The model was ${say(snapshot.modelAge, "s", 1e-6)} old.` : "";
    return line(target, "", `Contacts are found again where the object was.${old}`);
  }
  if (!Number.isFinite(snapshot.contactRate)) return line(target, "", "Contacts: not measured yet.");
  if (state && state.run !== "running") return line(target, "", `Contacts: ${state.run}.`);
  const age = Number.isFinite(snapshot.modelAge) ? `; the model is ${say(snapshot.modelAge, "s", 1e-6)} old` : "";
  const mood = !state ? "" : snapshot.modelWeight > 0.99 ? "good" : "warn";
  const dropped = snapshot.contactsDropped > 0 ? `; ${snapshot.contactsDropped} did not fit` : "";
  return line(target, mood,
    `Contacts found ${digits(snapshot.contactRate)} times a second, ${say(snapshot.queryCpu, "s", 1e-6)} each${age}${dropped}.`);
}

const ROW_KEYS = [["object", "the object"], ["hand", "where the hand holds it"], ["coupling", "coupling"], ["near", "rows near"], ["press", "rows that press"],
  ["cone", "friction cone"]];

/// What is drawn of constraints, with counts; hidden where there are none.
/// isWorld   of several bodies
export function showRowLegend(parent, snapshot, isWorld) {
  const constrained = Boolean(snapshot) && (snapshot.bits & STATE.constrained) !== 0;
  parent.hidden = !constrained;
  document.body.classList.toggle("constrained", constrained);
  if (!constrained) return;
  if (parent.childElementCount === 0) {
    parent.replaceChildren(...ROW_KEYS.map(([id, words]) => {
      const item = element("span", `swatch row-key ${id}`);
      item.append(element("i"), element("b", "", words), element("em"));
      return item;
    }));
  }
  const own = isWorld ? "in a hand" : ROW_KEYS[0][1], first = parent.children[0].children[1];
  if (first.textContent !== own) first.textContent = own;
  const pressing = snapshot.rows.filter(({ presses }) => presses);
  const grasped = (snapshot.bits & 1) !== 0;
  const counts = { object: null, hand: grasped ? null : 0, coupling: grasped ? null : 0, near: snapshot.rows.length - pressing.length,
    press: pressing.length, cone: pressing.filter(({ friction }) => friction > 0).length };
  ROW_KEYS.forEach(([id], k) => {
    const item = parent.children[k];
    item.classList.toggle("active", counts[id] !== 0);
    const text = counts[id] ? `×${counts[id]}` : "";
    if (item.lastChild.textContent !== text) item.lastChild.textContent = text;
  });
}

/// The colours of the levels, with how many contacts each has now.
export function showLegend(parent, snapshot, scene, browsed = "") {
  const levels = Math.min(LEVEL_COLOURS.length, Math.max(scene?.object.levels ?? 1, 1));
  if (parent.childElementCount !== levels + 2) {
    const swatches = Array.from({ length: levels }, (_, level) => {
      const item = element("span", "swatch", "");
      const more = level === levels - 1 && scene?.object.levels > levels ? "+" : ""; // the last stands for all coarser ones
      item.append(element("i"), element("b", "", `${level}${more}`), element("em"));
      item.firstChild.style.background = levelColour(level);
      return item;
    });
    parent.replaceChildren(element("span", "legend-title", "Level at contacts"), ...swatches, element("span", "legend-browsed"));
  }
  const counts = new Map();
  for (const [level, n] of levelCounts(snapshot?.contacts ?? [])) {
    const shown = Math.min(level, LEVEL_COLOURS.length - 1);
    counts.set(shown, (counts.get(shown) ?? 0) + n);
  }
  const shown = browsed ? `Patches of ${browsed}` : "";
  if (parent.lastChild.textContent !== shown) parent.lastChild.textContent = shown;
  [...parent.children].slice(1, -1).forEach((item, level) => {
    const n = counts.get(level) ?? 0;
    item.classList.toggle("active", n > 0);
    const text = n > 0 ? `×${n}` : "";
    if (item.lastChild.textContent !== text) item.lastChild.textContent = text;
  });
}
