// The sound of contact: the change of the force on the hand, frame by frame, as a loudspeaker plays it. Off by default.

const RATE = 8000; // of what is played [Hz]
const AHEAD = 0.08; // what arrives in batches is played without gaps [s]

/// One batch of forces as samples of sound: what changes from frame to frame, as a share of `full`, so that a steady press
/// is silent, a tap clicks and texture hums.
/// rows     [{time [s], force [N]}], about a thousand a second; last   the row before, null: none
/// full     force that is as loud as can be [N]
/// returns  {samples: Float32Array at RATE, last}
export function soundOf(rows, last, full) {
  const list = last ? [last, ...rows] : rows;
  const begin = list[0]?.time ?? 0, seconds = (list.at(-1)?.time ?? 0) - begin;
  if (!(seconds > 0) || seconds > 1 || !(full > 0)) return { samples: new Float32Array(0), last: list.at(-1) ?? null };
  const samples = new Float32Array(Math.floor(seconds * RATE));
  let k = 1;
  for (let n = 0; n < samples.length; n++) {
    const time = begin + n / RATE;
    while (k < list.length - 1 && list[k].time < time) k += 1;
    const change = (list[k].force - list[k - 1].force) / full;
    samples[n] = Number.isFinite(change) ? Math.tanh(12 * change) : 0;
  }
  return { samples, last: list.at(-1) };
}

export const makeSound = () => ({ context: null, on: false, last: null, until: 0, played: 0 });

/// Has to come from a press of somebody: browsers let no page be heard before.
export function toggleSound(sound) {
  sound.on = !sound.on;
  sound.last = null;
  if (sound.on) {
    sound.context ??= new AudioContext();
    sound.context.resume();
  } else sound.context?.suspend();
  return sound.on;
}

/// message   decoded `channels`; at   column of each name
export function playRows(sound, message, at, full) {
  if (!sound.on || !sound.context) return;
  const rows = Array.from({ length: message.rows }, (_, row) => {
    const cell = (name) => message.values[row * message.columns + at[name]];
    return { time: message.time + cell("t"), force: Math.hypot(cell("force_x"), cell("force_y"), cell("force_z")) };
  });
  const { samples, last } = soundOf(rows, sound.last, full);
  sound.last = last;
  if (samples.length === 0) return;
  const { context } = sound, buffer = context.createBuffer(1, samples.length, RATE);
  buffer.copyToChannel(samples, 0);
  const source = new AudioBufferSourceNode(context, { buffer });
  source.connect(context.destination);
  const now = context.currentTime;
  if (sound.until < now || sound.until > now + 3 * AHEAD) sound.until = now + AHEAD;
  source.start(sound.until);
  sound.until += samples.length / RATE;
  sound.played += 1;
}
