// Another scene, a recording, or a mesh of one's own: from a menu, or dropped on the page.
import { count, digits } from "./format.js";
import { encodeUpload } from "./protocol.js";
import { SCENE_FACTS } from "./scenefacts.js";
import { whatToTry } from "./scenes.js";
import { acceptedFiles, filesToDrop } from "./words.js";
import { button, element } from "./dom.js";

const TALL = 96; // of a picture in scenes.webp [px]
const UNITS = [["millimetres", 0.001], ["centimetres", 0.01], ["inches", 0.0254], ["metres", 1]];

/// ask     (message) -> promise of the `ack`; send (buffer) -> whether it went; room() -> bytes that wait to go
/// limit() bytes of a message; add([{model, unit}]) puts meshes into the scene that is being put together
export function makeOpener(dialog, { ask, send, room, limit, add }) {
  const opener = { dialog, ask, send, room, limit, add, menu: { scenes: [], recordings: [], meshes: [] }, name: "", model: null, busy: null };
  dialog.addEventListener("click", (event) => { if (event.target === dialog) dialog.close(); });
  for (const kind of ["dragenter", "dragover"]) {
    addEventListener(kind, (event) => {
      if (![...(event.dataTransfer?.types ?? [])].includes("Files")) return;
      event.preventDefault();
      document.body.classList.add("dropping");
    });
  }
  addEventListener("dragleave", (event) => { if (!event.relatedTarget) document.body.classList.remove("dropping"); });
  addEventListener("drop", (event) => {
    event.preventDefault();
    document.body.classList.remove("dropping");
    takeFiles(opener, [...(event.dataTransfer?.files ?? [])]);
  });
  return opener;
}

export function takeMenu(opener, menu) {
  opener.menu = menu;
  if (opener.dialog.open && !opener.model) showMenu(opener);
}

/// current   name of the scene that runs
export function openMenu(opener, current) {
  opener.name = current;
  opener.model = null;
  showMenu(opener);
  if (!opener.dialog.open) opener.dialog.showModal();
}

function showMenu(opener) {
  const { scenes, recordings, meshes = [] } = opener.menu;
  const list = (items) => {
    const group = element("div", "open-list");
    group.append(...items.map(({ name, title }) => {
      const item = button("", () => choose(opener, name), "open-item");
      item.append(element("b", "", title || name));
      const words = whatToTry(name) || (title && title !== name ? name : "");
      if (words) item.append(element("span", "note", words));
      addFacts(item, name);
      item.setAttribute("aria-current", String(name === opener.name));
      return item;
    }));
    return group;
  };
  const file = Object.assign(element("input"), { type: "file", accept: acceptedFiles(meshes), id: "mesh-file", multiple: true });
  file.addEventListener("change", () => takeFiles(opener, [...file.files]));
  const pick = element("label", "drop-zone");
  pick.htmlFor = file.id;
  pick.append(element("b", "", "Files of your own"), element("span", "note", filesToDrop(meshes)), file);
  const parts = [element("h2", "", "Open"), pick, element("h3", "", "Scenes"), list(scenes)];
  if (recordings.length > 0) parts.push(element("h3", "", "Recordings"), list(recordings));
  opener.dialog.replaceChildren(...parts, foot(opener, [button("Cancel", () => opener.dialog.close())]));
}

/// The picture of a scene of the program, and its size.
function addFacts(item, name) {
  const facts = SCENE_FACTS[name];
  if (!facts) return;
  const picture = element("i", "open-picture"); // its place in the pictures of all
  picture.style.backgroundPositionY = `${(-TALL * Object.keys(SCENE_FACTS).indexOf(name)).toFixed(0)}px`;
  picture.setAttribute("aria-hidden", "true");
  item.classList.add("pictured");
  item.append(element("span", "note", `${digits(1000 * facts.size)} mm, ${count(facts.triangles, "triangle")}`), picture);
}

function foot(opener, buttons, text = "") {
  const row = element("div", "dialog-foot");
  const said = element("p", "refusal", text);
  said.setAttribute("role", "alert");
  row.append(said, ...buttons);
  opener.said = said;
  return row;
}

async function choose(opener, name) {
  const ack = await attempt(opener, { type: "open", value: name });
  if (ack.ok) opener.dialog.close();
}

/// One request at a time; a refusal stands in the dialog.
async function attempt(opener, message) {
  if (opener.busy) return { ok: false };
  opener.dialog.classList.add("busy");
  opener.busy = opener.ask(message);
  const ack = await opener.busy;
  opener.busy = null;
  opener.dialog.classList.remove("busy");
  if (!ack.ok && opener.said) opener.said.textContent = ack.reason ?? "The program refused.";
  return ack;
}

// ---- a mesh

/// One is looked at, and placed as one wishes; several are put into the scene, each with its likeliest unit.
async function takeFiles(opener, files) {
  if (files.length <= 1) { if (files[0]) await takeFile(opener, files[0]); return; }
  const models = [];
  for (const file of files) {
    const ack = await takeFile(opener, file);
    if (!ack.ok || opener.model?.report === undefined || opener.model.report.verdict === "rejected") return; // the dialog says why
    models.push({ model: opener.model, unit: opener.model.unit });
  }
  opener.dialog.close();
  opener.add(models);
}

async function takeFile(opener, file) {
  while (opener.busy) await opener.busy; // nobody drops a file twice
  opener.model = { name: file.name };
  const bar = Object.assign(element("progress"), { max: 1, value: 0 });
  opener.dialog.replaceChildren(element("h2", "", file.name), element("p", "note", "Sending and looking at it …"), bar,
    foot(opener, [button("Cancel", () => opener.dialog.close())]));
  if (!opener.dialog.open) opener.dialog.showModal();
  const bytes = new Uint8Array(await file.arrayBuffer());
  const answer = attempt(opener, { type: "upload", name: file.name.slice(-120), value: bytes.length });
  await sendBytes(opener, bytes, bar);
  const ack = await answer;
  if (ack.ok && file.name.endsWith(".mcap")) opener.dialog.close(); // a recording is shown at once
  return ack;
}

/// In pieces, no more at a time than the connection takes.
async function sendBytes(opener, bytes, bar) {
  const piece = Math.max(1024, Math.min(opener.limit(), 65536) - 64);
  for (let at = 0; at < bytes.length && opener.busy;) {
    for (let k = 0; k < 8 && at < bytes.length && opener.room() < 4 * piece; k++) {
      if (!opener.send(encodeUpload(bytes.subarray(at, at + piece)))) return;
      at += piece;
    }
    bar.value = Math.min(1, at / bytes.length);
    await new Promise((resolve) => setTimeout(resolve, 10));
  }
}

/// What the program thinks of it.
export function takeModel(opener, model) {
  opener.model = model;
  const { report } = model;
  const usable = report.verdict === "usable", repairable = report.verdict === "repairable";
  const verdict = element("p", `verdict ${report.verdict}`, { usable: "Ready to use", repairable: "Needs repair first",
    rejected: "Cannot be used" }[report.verdict] ?? report.verdict);
  const facts = element("p", "", `${count(report.triangles, "triangle")}, ${report.closed ? "closed" : "open"}, ` +
    `${count(report.components, "part")}.`);
  const reasons = element("ul", "reasons");
  for (const text of [...report.reasons, ...report.warnings]) reasons.append(element("li", "", text));
  const unit = Object.assign(element("select"), { id: "mesh-unit" });
  const units = [...UNITS.map(([name, metres]) => [`${name} (${sizeWords(report, metres)})`, metres]),
    [`whatever makes it as large as the object (${sizeWords(report, model.object_radius / report.radius)})`, model.object_radius / report.radius]];
  unit.append(...units.map(([name, metres]) => new Option(name, String(metres))));
  unit.value = String(model.unit);
  const label = Object.assign(element("label", "", "Its unit is "), { htmlFor: unit.id });
  const size = element("p", "unit-choice");
  size.append(label, unit);
  const place = (how) => async () => {
    const ack = await attempt(opener, { type: "place", name: how, value: Number(unit.value), repair: repairable });
    if (ack.ok) opener.dialog.close();
  };
  const before = repairable ? "Repair and " : "";
  const buttons = [button("Cancel", () => opener.dialog.close())];
  if (usable || repairable) {
    buttons.push(button("Add it to the scene", async () => {
      opener.dialog.close();
      opener.add([{ model, unit: Number(unit.value) }]);
    }));
    buttons.push(button(before ? "Repair and touch it" : "Touch it", place("touch")), button(before ? "Repair and hold it" : "Hold it", place("hold"), "primary"));
  }
  opener.dialog.replaceChildren(element("h2", "", model.name), verdict, facts, reasons, ...(usable || repairable ? [size] : []),
    foot(opener, buttons));
  if (!opener.dialog.open) opener.dialog.showModal();
}

/// Its longest side with a unit: 82.0 mm.
function sizeWords(report, metres) {
  const long = metres * Math.max(...report.bounds.max.map((high, k) => high - report.bounds.min[k]));
  if (!Number.isFinite(long)) return "–";
  return long < 0.9995 ? `${digits(1000 * long)} mm` : `${digits(long)} m`;
}
