// The time slider of a recording.
import { iconButton, nameButton, setIcon } from "./icons.js";
import { duration } from "./format.js";
import { colour } from "./theme.js";

const SPEEDS = [0.05, 0.1, 0.25, 0.5, 1, 2, 4];

/// act   {pause, seek(time), speed(value)}
export function makeReplayBar(parent, act) {
  const bar = { parent, act, held: false, waiting: false, next: null };
  bar.play = iconButton("pause", "Pause", "P", act.pause);
  bar.slider = Object.assign(document.createElement("input"), { type: "range", min: 0, max: 1, step: "any" });
  bar.slider.setAttribute("aria-label", "Time in the recording");
  bar.text = document.createElement("output");
  bar.slider.addEventListener("input", () => { bar.held = true; seek(bar, Number(bar.slider.value)); });
  for (const kind of ["change", "blur"]) bar.slider.addEventListener(kind, () => { bar.held = false; });
  bar.speed = Object.assign(document.createElement("select"), { title: "How fast it is shown" });
  bar.speed.setAttribute("aria-label", bar.speed.title);
  bar.speed.append(...SPEEDS.map((value) => new Option(`${value} ×`, String(value))));
  bar.speed.value = "1";
  bar.speed.addEventListener("change", () => act.speed(Number(bar.speed.value)));
  bar.strip = document.createElement("canvas"); // the force over the whole recording, under the slider
  bar.strip.setAttribute("aria-hidden", "true");
  bar.force = [];
  const track = Object.assign(document.createElement("div"), { className: "track" });
  track.append(bar.strip, bar.slider);
  parent.append(bar.play, track, bar.speed, bar.text);
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

/// message   `strip` of the program
export function takeStrip(bar, { force }) {
  bar.force = force;
  bar.drawnAt = null;
}

/// Again where its width or the colours have changed.
function drawStrip(bar) {
  const { clientWidth: width, clientHeight: height } = bar.strip, tone = colour("force");
  const key = `${width} ${height} ${tone}`;
  if (bar.drawnAt === key || width === 0) return;
  bar.drawnAt = key;
  Object.assign(bar.strip, { width, height });
  const context = bar.strip.getContext("2d");
  const most = bar.force.reduce((sum, value) => Math.max(sum, value ?? 0), 0);
  context.clearRect(0, 0, width, height);
  context.fillStyle = tone;
  bar.force.forEach((value, k) => {
    const tall = most > 0 ? (height * (value ?? 0)) / most : 0;
    context.fillRect((k * width) / bar.force.length, height - tall, width / bar.force.length + 0.5, tall);
  });
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
  if (document.activeElement !== bar.speed) bar.speed.value = String(replay.speed ?? 1);
  drawStrip(bar);
  const paused = state.run === "paused";
  setIcon(bar.play, paused ? "play" : "pause");
  nameButton(bar.play, paused ? "Play" : "Hold", "P");
}
