// The tab in which a scene is put together: its objects by numbers, their handles in the picture, undo, save.
import { added, changed, commit, composeMessage, fromAngles, inHand, makeComposition, redo, revert, takeScene, toAngles, undo, without } from "./compose.js";
import { digits } from "./format.js";
import { button, element } from "./dom.js";

const MILLI = 1000;

/// ask     (message) -> promise of the `ack`; choose() opens the choice of files
/// handles (index or null, mode): shows the handles of an object
export function makeBuilder(parent, { ask, choose, handles }) {
  const builder = { parent, ask, choose, handles, composition: makeComposition(), scene: null, mode: "translate", isOpen: false, busy: false, isOwn: false,
    saved: "", refused: "", name: "" };
  addEventListener("keydown", (event) => {
    if (!builder.isOpen || event.target.closest?.("input, select, dialog") || !(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z") return;
    event.preventDefault();
    stepBack(builder, event.shiftKey ? redo : undo);
  });
  return builder;
}

export function openBuilder(builder, isOpen) {
  builder.isOpen = isOpen;
  showBuilder(builder);
}

/// A `scene` message has come, and its meshes are shown.
export function takeBuilderScene(builder, scene) {
  builder.scene = scene;
  takeScene(builder.composition, scene, builder.isOwn);
  showBuilder(builder);
}

/// Meshes that were dropped: [{model: `model` message, unit}].
export function addModels(builder, models) {
  let { objects } = builder.composition;
  for (const { model, unit } of models) objects = added(objects, model, unit, builder.scene);
  builder.composition.chosen = objects.length - 1;
  return apply(builder, objects);
}

/// A drag of the handles has ended.
export function movedTo(builder, pose) {
  return apply(builder, changed(builder.composition.objects, builder.composition.chosen, pose));
}

/// Makes it so, in the program too; what that refuses is as it was.
async function apply(builder, objects) {
  if (builder.busy) { showBuilder(builder); return { ok: false, reason: "the scene before is still being made" }; }
  commit(builder.composition, objects);
  const ack = await tell(builder);
  if (!ack.ok) revert(builder.composition);
  showBuilder(builder);
  return ack;
}

async function stepBack(builder, step) {
  if (builder.busy || !step(builder.composition)) return;
  const ack = await tell(builder);
  if (!ack.ok) (step === undo ? redo : undo)(builder.composition);
  showBuilder(builder);
}

async function tell(builder) {
  Object.assign(builder, { busy: true, isOwn: true, saved: "", refused: "" });
  showBuilder(builder);
  const ack = await builder.ask(composeMessage(builder.composition));
  Object.assign(builder, { busy: false, isOwn: false, refused: ack.ok ? "" : ack.reason ?? "The program refused." });
  return ack;
}

async function save(builder, isOneFile) {
  const name = builder.name.trim() || builder.composition.title.replace(/[^A-Za-z0-9 ._-]/g, "").trim();
  const ack = await builder.ask({ type: "save", name, value: isOneFile });
  if (!ack.ok) builder.refused = ack.reason ?? "The program refused.";
  showBuilder(builder);
}

/// `saved` of the program.
export function takeSaved(builder, { file }) {
  Object.assign(builder, { saved: file, refused: "" });
  showBuilder(builder);
}

// ---- what is shown

function showBuilder(builder) {
  const { composition, isOpen, mode, busy } = builder;
  const hasHandles = isOpen && !busy && composition.objects.length > 0;
  builder.handles(hasHandles ? composition.chosen : null, mode, isOpen);
  if (!isOpen) return;
  const focus = document.activeElement?.dataset?.field;
  const { objects, chosen } = composition;
  const list = element("div", "build-list");
  list.setAttribute("role", "listbox");
  list.setAttribute("aria-label", "Objects of the scene");
  list.append(...objects.map((one, k) => {
    const item = button("", () => { composition.chosen = k; showBuilder(builder); }, "open-item");
    item.setAttribute("role", "option");
    item.setAttribute("aria-selected", String(k === chosen));
    item.append(element("b", "", one.name), element("span", "note", k === 0 ? "in the hand" : "stands still"));
    return item;
  }));
  const parts = [tools(builder), list];
  if (objects[chosen]) parts.push(fields(builder, objects[chosen], chosen));
  parts.push(savePart(builder));
  builder.parent.replaceChildren(...parts);
  builder.parent.classList.toggle("busy", busy);
  if (focus) builder.parent.querySelector(`[data-field="${focus}"]`)?.focus();
}

function tools(builder) {
  const { composition, mode, busy } = builder;
  const row = element("div", "build-tools");
  const choice = (text, value) => {
    const made = button(text, () => { builder.mode = value; showBuilder(builder); }, "chip-button");
    made.setAttribute("aria-pressed", String(mode === value));
    return made;
  };
  const back = button("Undo", () => stepBack(builder, undo)), forth = button("Redo", () => stepBack(builder, redo));
  back.disabled = busy || composition.done.length === 0;
  forth.disabled = busy || composition.undone.length === 0;
  row.append(choice("Move", "translate"), choice("Turn", "rotate"), back, forth, button("Add a mesh", builder.choose));
  return row;
}

/// Numbers of an object; every change is one step that can be undone.
function fields(builder, one, index) {
  const box = element("div", "build-fields"), { objects } = builder.composition;
  const edit = (what) => apply(builder, changed(objects, index, what));
  const text = (label, field, value, set) => {
    const input = Object.assign(element("input", "value"), { type: "text", value, disabled: builder.busy });
    input.dataset.field = field;
    input.setAttribute("aria-label", label);
    input.addEventListener("change", () => set(input.value, input));
    return input;
  };
  const number = (label, field, value, set, { open = false } = {}) => text(label, field, value === null ? "" : digits(value), (given, input) => {
    const read = given.trim() === "" && open ? null : Number(given.replace(",", "."));
    if (read !== null && (given.trim() === "" || !Number.isFinite(read))) {
      builder.refused = `"${given}" is not a number.`;
      showBuilder(builder);
    } else if (given !== input.defaultValue) set(read);
  });
  const row = (label, unit, ...inputs) => {
    const made = element("div", "build-row");
    made.append(element("span", "", label), ...inputs, element("span", "unit", unit));
    box.append(made);
  };
  row("name", "", text("name", "name", one.name, (name) => edit({ name })));
  row("position", "mm", ...["x", "y", "z"].map((axis, k) => number(`position ${axis}, mm`, `position-${axis}`, MILLI * one.position[k],
    (value) => edit({ position: one.position.map((old, i) => (i === k ? value / MILLI : old)) }))));
  const angles = toAngles(one.quaternion);
  row("turned about", "°", ...["x", "y", "z"].map((axis, k) => number(`turned about ${axis}, degrees`, `turn-${axis}`, angles[k],
    (value) => edit({ quaternion: fromAngles(angles.map((old, i) => (i === k ? value : old))) }))));
  row("friction", "", number("friction", "friction", one.friction, (friction) => edit({ friction }), { open: true }));
  if (index === 0) {
    row("mass", "g", number("mass, g", "mass", one.mass === null ? null : MILLI * one.mass,
      (mass) => edit({ mass: mass === null ? null : mass / MILLI, density: null }), { open: true }));
    row("or density", "kg/m³", number("density, kg/m³", "density", one.density, (density) => edit({ density, mass: null }), { open: true }));
  }
  if (!/^scene:/.test(one.source ?? "")) {
    row("unit", `m, ${digits(MILLI * one.size)} mm long`, number("metres per unit", "unit", one.unit,
      (unit) => edit({ unit, size: (one.size * unit) / one.unit }), {}));
  }
  const acts = element("div", "build-tools");
  if (index > 0) acts.append(button("Take it in the hand", () => { builder.composition.chosen = 0; apply(builder, inHand(objects, index)); }));
  const away = button("Remove", () => apply(builder, without(objects, index)));
  away.disabled = objects.length < 2;
  acts.append(away);
  box.append(acts);
  return box;
}

function savePart(builder) {
  const box = element("div", "build-save");
  const name = Object.assign(element("input", "value"), { type: "text", value: builder.name, placeholder: builder.composition.title });
  name.dataset.field = "save-name";
  name.setAttribute("aria-label", "Name to save it under");
  name.addEventListener("change", () => { builder.name = name.value; });
  const keep = button("Save", () => save(builder, false), "primary"), send = button("Save as one file", () => save(builder, true));
  const said = element("p", builder.refused ? "refusal" : "note", builder.refused || (builder.saved ? `Saved: ${builder.saved}` : ""));
  said.setAttribute("role", builder.refused ? "alert" : "status");
  const row = element("div", "build-tools");
  row.append(name, keep, send);
  box.append(row, said);
  return box;
}
