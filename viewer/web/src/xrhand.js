// The hand of a headset: which controller holds, and what its way in the room is in the world. Logic without a browser.
// XR axes: x right, y up, z towards the person; [m]. The world: z up, [m].
import { aboutAxis, conjugate, moveHand, multiply, rotate, turnHandBy } from "./hand.js";

const SMALLEST = 0.06, LARGEST = 1.5; // radius of the scene in the room [m]

/// How the scene stands in the room: seen as from `azimuth` of the page's view [rad], `shown` its radius there [m].
/// radius   of the scene in the world [m]
/// returns  {azimuth, radius, shown, turn: world_from_xr, metres: of the world a metre of the room}
export function makeRoom(azimuth, shown, radius) {
  const size = Math.max(SMALLEST, Math.min(LARGEST, shown));
  const turn = multiply(aboutAxis([0, 0, 1], azimuth + Math.PI / 2), aboutAxis([1, 0, 0], Math.PI / 2));
  return { azimuth, radius, shown: size, turn, metres: radius / size };
}

export function makeXrHand() {
  return { source: null, last: null, isHeld: false, down: new Set() };
}

/// A frame of the headset moves the hand by the controller that holds.
/// inputs    [{source, grabs: trigger, free: squeeze, pose: {position, quaternion} of the grip [XR], null: not tracked}]
/// returns   "press" where one takes hold; "letGo" where it lets go, is not tracked any more or is gone, and then only a
///           new press of its trigger takes hold again; else null
export function stepXrHand(xr, inputs, room, hand, workspace) {
  const before = new Set(xr.down);
  for (const { source, grabs } of inputs) { // one that is gone for a while has not let go of its trigger
    if (grabs) xr.down.add(source);
    else xr.down.delete(source);
  }
  if (xr.source === null) {
    const taker = inputs.find(({ source, grabs, pose }) => grabs && pose && !before.has(source));
    if (!taker) return null;
    Object.assign(xr, { source: taker.source, last: taker.pose, isHeld: false });
    return "press";
  }
  const holder = inputs.find(({ source }) => source === xr.source);
  if (!holder?.grabs || !holder.pose || (xr.isHeld && !hand.clutch)) {
    dropXrHand(xr);
    return "letGo";
  }
  xr.isHeld ||= hand.clutch;
  if (!holder.free) follow(xr.last, holder.pose, room, hand, workspace);
  xr.last = holder.pose;
  return null;
}

/// Nobody holds; whose trigger is down has to press it again.
export function dropXrHand(xr) {
  Object.assign(xr, { source: null, last: null, isHeld: false });
}

/// The object goes with the controller as it is shown: one centimetre in the room is one of the picture there.
function follow(from, to, room, hand, workspace) {
  const way = rotate(room.turn, to.position.map((value, k) => value - from.position[k]));
  moveHand(hand, way.map((value) => value * room.metres), workspace);
  const turned = multiply(to.quaternion, conjugate(from.quaternion));
  turnHandBy(hand, multiply(multiply(room.turn, turned), conjugate(room.turn)), workspace);
}
