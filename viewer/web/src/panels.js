// Parameters, events and help.
import { digits } from "./format.js";
import { eventWords } from "./words.js";
import { element } from "./dom.js";

/// Position of a slider, 0 to 1, for a value, and back; both logarithmic or both straight.
export function toSlider({ min, max, scale }, value) {
  const share = scale === "log" ? Math.log(value / min) / Math.log(max / min) : (value - min) / (max - min);
  return Math.max(0, Math.min(1, share));
}
export function fromSlider({ min, max, scale }, share) {
  return scale === "log" ? min * (max / min) ** share : min + share * (max - min);
}

/// Three digits that count, as short as they go: 0.000123, 500, 0.025.
export const short = (value) => String(Number(value.toPrecision(3)));

/// ask   (name, value) -> promise of the `ack`
export function makeParameters(parent, ask) {
  return { parent, ask, rows: new Map() };
}

/// list   of the `parameters` message; a control in use is left alone
export function showParameters(panel, list) {
  const names = new Set(list.map((one) => one.name));
  for (const [name, row] of panel.rows) if (!names.has(name)) { row.box.remove(); panel.rows.delete(name); }
  for (const parameter of list) {
    if (!panel.rows.has(parameter.name)) panel.rows.set(parameter.name, makeRow(panel, parameter));
    fillRow(panel.rows.get(parameter.name), parameter);
  }
}

/// A choice of words: buttons, the chosen one pressed.
function makeChoice(panel, parameter) {
  const box = element("div", "parameter"), top = element("div", "parameter-top"), words = element("span", "words");
  const label = element("label", "", parameter.label), help = element("p", "note"), refusal = element("p", "refusal");
  const warning = element("p", "warning");
  refusal.setAttribute("role", "alert");
  words.setAttribute("role", "radiogroup");
  words.setAttribute("aria-label", parameter.label);
  const buttons = parameter.choices.map((word, index) => {
    const button = Object.assign(element("button", "chip-button", word), { type: "button" });
    button.setAttribute("role", "radio");
    button.addEventListener("click", () => { if (row.parameter.value !== index) request(panel, row, index); });
    words.append(button);
    return button;
  });
  top.append(label, words);
  box.append(top, help, refusal, warning);
  panel.parent.append(box);
  const row = { box, buttons, help, refusal, warning, parameter, busy: false, next: null };
  return row;
}

function makeRow(panel, parameter) {
  if (parameter.kind === "choice") return makeChoice(panel, parameter);
  const box = element("div", "parameter");
  const label = element("label", "", parameter.label);
  const slider = Object.assign(element("input"), { type: "range", min: 0, max: 1, step: 0.001, id: `parameter-${parameter.name}` });
  label.htmlFor = slider.id;
  const number = Object.assign(element("input", "value"), { type: "text", inputMode: "decimal" });
  number.setAttribute("aria-label", `${parameter.label}, ${parameter.unit}`);
  const unit = element("span", "unit", parameter.unit), help = element("p", "note"), refusal = element("p", "refusal");
  refusal.setAttribute("role", "alert");
  const top = element("div", "parameter-top"), warning = element("p", "warning");
  const row = { box, slider, number, help, refusal, warning, parameter, busy: false, next: null, on: null };
  if (parameter.kind === "optional") {
    row.on = Object.assign(element("input", "switch"), { type: "checkbox" });
    row.on.setAttribute("aria-label", `${parameter.label} on`);
    row.kept = parameter.value || fromSlider(parameter, 0.5);
    row.on.addEventListener("change", () => request(panel, row, row.on.checked ? Number(short(row.kept)) : 0));
    top.append(row.on);
  }
  top.append(label, number, unit);
  box.append(top, slider, help, refusal, warning);
  panel.parent.append(box);
  slider.addEventListener("input", () => {
    const value = Number(short(fromSlider(row.parameter, Number(slider.value))));
    number.value = short(value);
    request(panel, row, value);
  });
  number.addEventListener("change", () => {
    const value = Number(number.value.replace(",", "."));
    if (number.value.trim() !== "" && Number.isFinite(value)) request(panel, row, value);
    else refuse(row, `"${number.value}" is not a number.`);
  });
  return row;
}

/// One request at a time; of those asked for meanwhile only the newest is made.
async function request(panel, row, value) {
  if (row.busy) { row.next = value; return; }
  row.busy = true;
  const ack = await panel.ask(row.parameter.name, value);
  row.busy = false;
  if (row.next !== null) {
    const next = row.next;
    row.next = null;
    request(panel, row, next);
    return;
  }
  if (!ack.ok) { refuse(row, ack.reason ?? "Refused."); return; }
  row.refusal.textContent = "";
  row.parameter = { ...row.parameter, value: ack.value ?? value };
  writeRow(row);
  row.box.classList.remove("changed");
  void row.box.offsetWidth; // begins the flash anew
  row.box.classList.add("changed");
}

function refuse(row, reason) {
  const { value, unit, choices } = row.parameter;
  const stays = choices?.length > 0 ? choices[value] : row.on && value === 0 ? "off" : `${short(value)} ${unit}`.trim();
  row.refusal.textContent = `${reason.replace(/[.]?$/, ".")} It stays at ${stays}.`;
  writeRow(row);
}

function fillRow(row, parameter) {
  row.parameter = parameter;
  const anew = parameter.begins_again ? " Begins again." : "";
  row.help.textContent = parameter.locked ?? `${parameter.help ?? ""}${anew}`;
  row.warning.textContent = parameter.warning ? `Risky: ${parameter.warning}.` : "";
  const locked = Boolean(parameter.locked);
  row.box.classList.toggle("locked", locked);
  for (const control of [row.slider, row.number, row.on, ...(row.buttons ?? [])]) if (control) control.disabled = locked;
  if (!row.busy && document.activeElement !== row.number) writeRow(row);
}

function writeRow(row) {
  const { value } = row.parameter;
  row.buttons?.forEach((button, index) => button.setAttribute("aria-checked", String(index === value)));
  if (row.buttons) return;
  const off = row.on !== null && value === 0;
  if (row.on) {
    row.on.checked = !off;
    if (!off) row.kept = value;
    row.box.classList.toggle("off", off);
  }
  row.slider.value = toSlider(row.parameter, off ? row.kept : value);
  row.number.value = off ? "off" : short(value);
}

const KEPT = 200;

export function addEvent(parent, event) {
  const item = element("div", `event ${event.kind}`);
  item.append(element("time", "", `${digits(event.time)} s`), element("span", "", eventWords(event)));
  parent.prepend(item);
  while (parent.childElementCount > KEPT) parent.lastChild.remove();
}

const HELP = [
  ["Drag", "moves the hand in the plane of the screen"],
  ["Wheel while dragging, or Shift + drag", "moves it away from you and back"],
  ["Ctrl or Alt + drag", "turns it"],
  ["Space", "lets go, or takes hold"],
  ["Arrow keys, Page up and down", "move the hand that holds, on the picture; with Ctrl or Alt they turn it, with Shift the view"],
  ["Right drag, wheel", "turns and zooms the view; middle drag shifts it"],
  ["Touch", "one finger on the object moves it, a second turns and lifts it; beside it fingers move the view"],
  ["Gamepad", "sticks move and turn, triggers push and pull, A holds, B lets go; it rumbles with the force"],
  ["VR or AR", "where a headset is there: the trigger holds, squeezing frees the controller, its stick turns and sizes the scene"],
  ["Scene tab", "put a scene together: drop meshes, drag the handles, Ctrl+Z takes a step back"],
  ["P . R O", "pause, one step, begin again, open a scene"],
  ["F L G C A N", "fit the view; levels of detail, ghost, contacts, arrows, names on and off"],
  ["S", "sound of contact on and off: changes of the force"],
  ["1 to 6, + -", "look along the axes, as the buttons of the compass do; nearer and farther"],
];

export function fillHelp(dialog) {
  const title = element("h2", "", "The mouse is the hand");
  const sentence = element("p", "lead", "Drag the blue object: the ghost shows where your hand is, the object where it " +
    "may be, and the line between them, as long as the force is strong, is what a haptic device would let you feel.");
  const table = element("dl");
  for (const [keys, does] of HELP) {
    const kind = /^(Drag|Touch|Gamepad)$/.test(keys) ? "" : "for-mouse";
    table.append(element("dt", kind, keys), element("dd", kind, does));
  }
  const marks = element("p", "note");
  marks.append(swatch("force", "force on the hand"), swatch("torque", "torque, turning along the arc"),
    swatch("ring", "clusters of contacts"),
    swatch("levels", "dots: contacts with their normals, in the colour of their level of detail"),
    swatch("contact", "under constraints, discs: planes that the object keeps off, with the points they keep off"),
    swatch("press", "those that press, with their force and the cone it may lie in"));
  const close = Object.assign(element("button", "primary", "Close"), { type: "button" });
  close.addEventListener("click", () => dialog.close());
  dialog.addEventListener("click", (event) => { if (event.target === dialog) dialog.close(); });
  dialog.replaceChildren(title, sentence, table, marks, close);
}

function swatch(name, text) {
  const item = element("span", `key ${name}`, text);
  item.prepend(element("i"));
  return item;
}
