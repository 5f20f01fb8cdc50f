// How much of a picture this machine can afford while things move, from how long the last ones took. The processor of a
// computer without graphics hardware draws, too, and has an engine and a hand to serve beside it.

/// From all of it to the least: pixels along a side, of those the screen has, and whether there are shadows.
export const STEPS = [{ ratio: 1, shadows: true }, { ratio: 0.7, shadows: true }, { ratio: 0.5, shadows: false }, { ratio: 0.35, shadows: false }];

export const SLOW = 0.1; // a hand feels this much lag [s]
export const FAST = 0.04; // two frames of a screen: more cannot be told from the drawing itself [s]
const SETTLE = 2; // pictures that pay for a change: new shaders, new buffers
const FEW = 3; // pictures that show one is too slow
const MANY = 60; // pictures that show there is room for more

/// step    to begin with; fixed: whatever the machine
export function makePace({ step = 0, fixed = false } = {}) {
  return { step, fixed, seen: 0, mean: 0, patience: MANY, climbed: false };
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
  if (known >= pace.patience && pace.mean < FAST && pace.step > 0) {
    change(pace, -1);
    return true;
  }
  return false;
}

function change(pace, by) {
  Object.assign(pace, { step: pace.step + by, seen: 0, mean: 0, climbed: by < 0 });
}

/// How long to leave the machine to others after a picture [s]: as long as it took, where that is felt.
export const restAfter = (seconds, plain) => (plain || seconds > FAST ? seconds : 0);
