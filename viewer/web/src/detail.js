// Which level of detail of an object is drawn: the coarsest whose surface, and so its outline, is nowhere farther off the
// original than some pixels.

/// list     `level_list` of the object in `scene`
/// metres   that one pixel covers at the object's nearest point
/// pixels   that what is drawn may be off; 0: the original
export function levelToDraw(list, metres, pixels) {
  let best = 0;
  (list ?? []).forEach(({ free, triangles, deviation }, level) => {
    const isThere = level > 0 && !free && triangles > 0 && Number.isFinite(deviation) && deviation !== null;
    if (isThere && deviation <= pixels * metres && triangles < list[best].triangles) best = level;
  });
  return best;
}

/// Of what is to be drawn the finest that is here but no finer than asked, else the next finer one; 0 is always here.
/// isHere   (level) -> whether its surface is
export function levelAtHand(wanted, isHere) {
  for (let level = wanted; level > 0; level--) if (isHere(level)) return level;
  return 0;
}

/// Of surfaces made for drawing alone the coarsest that is off by no more than allowed: -1 for the first, -2 for the second ...;
/// 0, the original, where none is.
/// list   [{deviation}], finer ones first; allowed   in the same unit
export function coarsestWithin(list, allowed) {
  for (let k = list.length; k > 0; k--) if (list[k - 1].deviation <= allowed) return -k;
  return 0;
}

/// The ball around the points of each patch, about the middle of their box: [x, y, z, radius] a patch; radius -1 without points.
/// labels   patch of each vertex, below 0: of none
export function patchBalls(positions, labels, patches) {
  const low = new Float64Array(3 * patches).fill(Infinity), high = new Float64Array(3 * patches).fill(-Infinity);
  for (let v = 0; v < labels.length; v++) {
    for (let k = 0; labels[v] >= 0 && k < 3; k++) {
      const at = 3 * labels[v] + k, value = positions[3 * v + k];
      if (value < low[at]) low[at] = value;
      if (value > high[at]) high[at] = value;
    }
  }
  const balls = new Float32Array(4 * patches).fill(-1);
  for (let p = 0; p < patches; p++) {
    if (!(low[3 * p] <= high[3 * p])) continue;
    let across = 0;
    for (let k = 0; k < 3; k++) {
      balls[4 * p + k] = 0.5 * (low[3 * p + k] + high[3 * p + k]);
      across += (high[3 * p + k] - low[3 * p + k]) ** 2;
    }
    balls[4 * p + 3] = 0.5 * Math.sqrt(across);
  }
  return balls;
}

/// Patches whose ball comes within `reach` of a spot: 255 in `into`, else 0.
/// spots   [{point}]
export function reachPatches(balls, spots, reach, into) {
  into.fill(0);
  for (const { point: [x, y, z] } of spots) {
    for (let p = 0; p < into.length; p++) {
      const within = balls[4 * p + 3] + reach;
      if (balls[4 * p + 3] < 0) continue;
      const dx = balls[4 * p] - x, dy = balls[4 * p + 1] - y, dz = balls[4 * p + 2] - z;
      if (dx * dx + dy * dy + dz * dz < within * within) into[p] = 255;
    }
  }
}
