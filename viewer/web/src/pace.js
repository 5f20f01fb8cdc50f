// How much of a picture this machine can afford while things move, from how long the last ones took. The processor of a
// computer without graphics hardware draws, too, and has an engine and a hand to serve beside it.

/// From all of it to the least: pixels of the screen for one of the page, shadows, highlights, how many pixels of the page a
/// surface, and so its outline, may be off the original, and how many times as long a picture of the step before may take. The
/// view always has its full size. Farther off than two pixels triangles cost less than the pixels that they cover.
export const STEPS = [
  { pixels: 2, shadows: true, rich: true, off: 0, before: Infinity },
  { pixels: 1, shadows: true, rich: true, off: 0, before: 4 },
  { pixels: 1, shadows: false, rich: true, off: 0.5, before: 4 },
  { pixels: 1, shadows: false, rich: false, off: 0.5, before: 7 },
  { pixels: 1, shadows: false, rich: false, off: 1, before: 1.7 },
  { pixels: 1, shadows: false, rich: false, off: 2, before: 1.7 },
];
export const PLAIN_STEP = 3; // to begin with where the processor draws: it may turn out a fast one
const LONGEST = 1 / 20; // from one picture to the next is aimed at, where that can be had [s]

export const SLOW = 0.045; // [s]
export const isFast = (step, seconds) => seconds * STEPS[step].before < SLOW; // there is room for the step before
const SETTLE = 2; // pictures that pay for a change: new shaders, new buffers
const FEW = 3; // pictures that show one is too slow
const MANY = 60; // pictures that show there is room for more

/// step    to begin with; fixed: whatever the machine
export function makePace({ step = 0, fixed = false } = {}) {
  return { first: step, step, fixed, seen: 0, mean: 0, patience: MANY, climbed: false };
}

/// After each picture; true when the step has changed.
/// seconds   from its begin until it was done
export function notePicture(pace, seconds) {
  pace.seen += 1;
  if (pace.fixed || pace.seen <= SETTLE) return false;
  const known = pace.seen - SETTLE;
  pace.mean += (seconds - pace.mean) / Math.min(known, 8);
  if (known >= FEW && pace.mean > SLOW && pace.step < STEPS.length - 1) {
    if (pace.climbed) pace.patience *= 4; // or it would go up and down for ever
    change(pace, 1);
    return true;
  }
  if (known >= pace.patience && isFast(pace.step, pace.mean)) {
    change(pace, -1);
    return true;
  }
  return false;
}

/// Coarser surfaces are there: as fine again as they can be at the most.
export function beginAgain(pace) {
  const step = Math.max(pace.first, STEPS.findIndex(({ off }) => off > 0));
  if (!pace.fixed && step < pace.step) Object.assign(pace, { step, seen: 0, mean: 0, patience: MANY, climbed: false });
}

function change(pace, by) {
  Object.assign(pace, { step: pace.step + by, seen: 0, mean: 0, climbed: by < 0 });
}

/// How long to leave the machine to others after a picture [s]: as long as it took where the processor draws, but no longer
/// than LONGEST allows; a picture that takes longer than that leaves a quarter of its time.
/// plain   the processor draws
export function restAfter(seconds, plain) {
  if (!plain && seconds < SLOW) return 0;
  return Math.max(0.25 * seconds, Math.min(seconds, LONGEST - seconds - 0.01));
}
