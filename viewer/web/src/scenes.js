// What to try in the scenes of the program.

const TRY = {
  ball_joint: "Turn the ball in its socket: it has half a millimetre of play.",
  block_on_gear: "Drag the block over the gear: ridges catch ridges.",
  blocks: "Turn the upper block about the vertical: its stripes climb out of the others.",
  conforming: "Press the waves together and turn: everything touches at once.",
  cup_spoon: "Lead the spoon through the handle of the cup.",
  ellipsoid: "Roll the ellipsoid over the ball; its tip and its flank feel different.",
  file_on_cad: "Scrape the file over the flange: rough on rough.",
  golf: "Tap the ball, then slide the club over its dimples.",
  hammer_on_torus: "Stroke the ring with the hammer, along and across its ridges.",
  jaws: "Close the bite, then slide the cusps over each other.",
  plate: "Draw the probe across the ridges, slowly and fast.",
  simple_cup_spoon: "Lead the spoon through the handle: few triangles, the same way.",
  spoon_in_cup: "Nobody holds it: watch the spoon fall into the cup.",
};

/// "" for one that is not known.
export const whatToTry = (name) => TRY[name] ?? "";
export const SCENES_WITH_WORDS = Object.keys(TRY);
