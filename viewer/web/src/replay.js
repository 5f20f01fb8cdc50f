// The time slider of a recording.
import { iconButton, nameButton, setIcon } from "./icons.js";
import { duration } from "./format.js";

/// act   {pause, seek(time)}
export function makeReplayBar(parent, act) {
  const bar = { parent, act, held: false, waiting: false, next: null };
  bar.play = iconButton("pause", "Pause", "P", act.pause);
  bar.slider = Object.assign(document.createElement("input"), { type: "range", min: 0, max: 1, step: "any" });
  bar.slider.setAttribute("aria-label", "Time in the recording");
  bar.text = document.createElement("output");
  bar.slider.addEventListener("input", () => { bar.held = true; seek(bar, Number(bar.slider.value)); });
  for (const kind of ["change", "blur"]) bar.slider.addEventListener(kind, () => { bar.held = false; });
  parent.append(bar.play, bar.slider, bar.text);
  return bar;
}

/// One at a time; of those asked for meanwhile only the newest is made.
async function seek(bar, time) {
  if (bar.waiting) { bar.next = time; return; }
  bar.waiting = true;
  await bar.act.seek(time);
  bar.waiting = false;
  const next = bar.next;
  bar.next = null;
  if (next !== null) seek(bar, next);
}

export function showReplayBar(bar, state, snapshot) {
  const replay = state?.replay ?? null;
  bar.parent.hidden = !replay;
  if (!replay) return;
  const time = bar.held || bar.waiting ? Number(bar.slider.value) : snapshot?.time ?? 0;
  bar.slider.max = replay.seconds;
  if (!bar.held && !bar.waiting) bar.slider.value = time;
  bar.slider.setAttribute("aria-valuetext", `${duration(time)} of ${duration(replay.seconds)}`);
  bar.text.textContent = `${duration(time)} / ${duration(replay.seconds)}`;
  const paused = state.run === "paused";
  setIcon(bar.play, paused ? "play" : "pause");
  nameButton(bar.play, paused ? "Play" : "Hold", "P");
}
