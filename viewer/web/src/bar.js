// The bar on top and the buttons on the picture.
import { icon, iconButton, nameButton, setIcon } from "./icons.js";
import { duration } from "./format.js";
import { deviceWords, END_WORDS, endWords, faultWords } from "./words.js";

/// act   {open, pause, step, reset, record, theme, help, device(uri), letGo, view(option), sound, fit, add, remove: of bodies in a world}
export function makeBar(act) {
  const controls = document.getElementById("controls"), tools = document.getElementById("view-tools");
  const bar = {
    title: document.getElementById("title"), chip: document.getElementById("state"),
    open: iconButton("open", "Open a scene or a mesh", "O", act.open), pause: iconButton("pause", "Pause", "P", act.pause), step: iconButton("step", "One step", ".", act.step),
    reset: iconButton("reset", "Begin again", "R", act.reset), record: iconButton("record", "Record", "", act.record),
    theme: iconButton("theme", "Light or dark", "", act.theme), help: iconButton("help", "Help", "?", act.help),
    device: document.createElement("select"), views: {}, headset: {}, act,
  };
  bar.device.title = "Who moves the object";
  bar.device.setAttribute("aria-label", bar.device.title);
  bar.device.addEventListener("change", () => act.device(bar.device.value));
  const group = (...parts) => {
    const span = Object.assign(document.createElement("span"), { className: "group" });
    span.append(...parts);
    return span;
  };
  controls.append(group(bar.open), group(bar.device), group(bar.pause, bar.step, bar.reset, bar.record), group(bar.theme, bar.help));
  const views = [["levels", "Levels of detail: finest as wireframe", "L", "wireframe"], ["ghost", "Ghost of the hand", "G", "ghost"],
    ["contacts", "Contacts and clusters", "C", "contacts"], ["forces", "Force and torque", "A", "forces"],
    ["names", "Names of the objects", "N", "names"]];
  for (const [name, label, key, option] of views) {
    bar.views[option] = iconButton(name, label, key, () => act.view(option));
    tools.append(bar.views[option]);
  }
  bar.sound = iconButton("sound", "Sound of contact", "S", act.sound);
  showSound(bar, false);
  tools.append(iconButton("add", "Another body like the one touched last", "", act.add), iconButton("remove", "Take the body touched last away", "", act.remove));
  tools.append(bar.sound, iconButton("fit", "Fit the view", "F", act.fit));
  return bar;
}

/// Buttons for what a headset can do, once that is known.
/// modes    [[mode, name]]; enter(mode)
export function addHeadset(bar, modes, enter) {
  for (const [mode, name] of modes) {
    bar.headset[mode] = iconButton(mode === "immersive-ar" ? "room" : "headset", name, "", () => enter(mode));
    document.getElementById("view-tools").append(bar.headset[mode]);
  }
  showHeadset(bar, null);
}
export function showHeadset(bar, now) {
  for (const [mode, button] of Object.entries(bar.headset)) button.setAttribute("aria-pressed", String(mode === now));
}

export function showSound(bar, on) {
  bar.sound.setAttribute("aria-pressed", String(on));
}

export function showViews(bar, options) {
  for (const [option, button] of Object.entries(bar.views)) {
    button.setAttribute("aria-pressed", String(options[option]));
  }
}

/// What runs, in a word with its time. `connected` false: nothing else is known any more.
export function showState(bar, session) {
  const { state, scene, shown: snapshot, connected } = session;
  bar.title.textContent = scene?.title ?? "";
  document.title = scene ? `${scene.title} · Thigma` : "Thigma";
  const run = !connected ? "lost" : state?.run ?? "connecting";
  const time = snapshot ? ` · ${duration(snapshot.time)}` : "";
  const words = { lost: "connection lost", connecting: "connecting", running: `running${time}`, paused: `paused${time}`,
    ended: session.progress ? "preparing" : END_WORDS[state?.reason] ?? "ended" };
  if (state?.late) words.running += ` · late ${state.late.count}×`;
  const faulty = run === "running" && (snapshot?.bits & 4) !== 0;
  if (state?.replay && run === "running") words.running = `replaying${time}`;
  bar.chip.textContent = faulty ? `forces off: ${faultWords(session.faultName())}` : words[run];
  bar.chip.title = run === "ended" ? endWords(state) ?? "" : state?.late?.text ?? "";
  bar.chip.dataset.run = faulty ? "fault" : run;
  const alive = connected && Boolean(state);
  const paused = state?.run === "paused";
  setIcon(bar.pause, paused ? "play" : "pause");
  nameButton(bar.pause, paused ? "Go on" : "Pause", "P");
  bar.pause.disabled = !alive || state.run === "ended";
  bar.step.disabled = !alive || !paused;
  bar.reset.disabled = bar.record.disabled = !alive;
  bar.open.disabled = !alive || Boolean(scene?.world); // a world stays
  const recording = Boolean(state?.recording);
  setIcon(bar.record, recording ? "stop" : "record");
  bar.record.classList.toggle("on", recording);
  nameButton(bar.record, recording ? `Stop recording ${state.recording}` : "Record from the start", "");
  showDevices(bar, state, alive);
}

function showDevices(bar, state, alive) {
  const uris = [...new Set([...(state?.devices ?? []), ...(state ? [state.device] : [])])];
  if (bar.device.dataset.uris !== uris.join(" ")) {
    bar.device.dataset.uris = uris.join(" ");
    bar.device.replaceChildren(...uris.map((uri) => new Option(deviceWords(uri), uri)));
  }
  bar.device.hidden = uris.length === 0;
  bar.device.disabled = !alive || uris.length < 2;
  if (state && document.activeElement !== bar.device) bar.device.value = state.device;
}

/// One line over the picture, perhaps with a button; null hides it.
export function showHint(hint, content) {
  const key = content ? `${content.text}|${content.button ?? ""}` : "";
  if (hint.dataset.key === key) return;
  hint.dataset.key = key;
  hint.hidden = !content;
  if (!content) return;
  const text = Object.assign(document.createElement("span"), { textContent: content.text });
  hint.className = `hint ${content.mood ?? ""}`;
  hint.replaceChildren(...(content.icon ? [icon(content.icon)] : []), text);
  if (!content.button) return;
  const button = Object.assign(document.createElement("button"), { type: "button", textContent: content.button });
  button.addEventListener("click", content.act);
  hint.append(button);
}
