// Worlds of several bodies in the picture: where each is, which a hand holds, and which lies under the pointer.
import { Color, Raycaster, Vector2 } from "three";
import { paintBody } from "./body.js";
import { colour } from "./theme.js";

/// made   [the object, ...the statics] as drawn, in the order of the `scene` message
/// returns   {byNumber: bodies by their number in `bodies`, held: numbers in hands}; null where the scene is no world
export function makeWorld(description, made) {
  if (!description.world) return null;
  const byNumber = [];
  for (const body of made) byNumber[body.about.body] = body;
  return { byNumber, held: [], shown: null };
}

/// Puts all bodies where a `bodies` message has them; those in hands change their colour.
/// sky   strength of the light from above
export function placeBodies(world, message, sky) {
  message.bodies.forEach(({ position, quaternion }, number) => {
    const group = world.byNumber[number]?.group;
    group?.position.fromArray(position);
    group?.quaternion.fromArray(quaternion);
  });
  const held = message.hands.map(({ body }) => body).filter((body) => world.byNumber[body]);
  world.shown = world.byNumber[shownHand(message)?.body] ?? world.shown;
  if (held.join() === world.held.join()) return;
  world.held = held;
  paintWorld(world, sky);
}

/// The hand whose force and ghost are shown: this page's while it holds something, else the first that does.
export function shownHand({ hands }) {
  const holds = ({ body }) => body >= 0;
  return hands.find((hand) => hand.page && holds(hand)) ?? hands.find(holds) ?? null;
}

const SPREAD = 0.14; // of lightness: like bodies on each other are told apart

/// Neighbours in the order of numbers are never alike.
const shade = (base, number) => new Color(base).offsetHSL(0, 0, SPREAD * (((0.618 * number) % 1) - 0.5));

/// Bodies in hands, those that move, and those that stand still, each in a colour of its own.
export function paintWorld(world, sky) {
  world.byNumber.forEach((body, number) => {
    const kind = world.held.includes(number) ? "held" : body.about.moves ? "moving" : "fixed";
    paintBody(body, { base: kind === "moving" ? shade(colour(kind), number) : colour(kind), line: colour(`${kind}-line`), sky });
  });
}

/// The body that a press takes: the nearest one under the pointer, if it moves.
/// event   {clientX, clientY}; null: the middle of the picture
/// returns   {name, point: [m; mesh frame]} or null
export function pickBody({ canvas, view, world }, event) {
  const box = canvas.getBoundingClientRect();
  const at = event ? new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2) : new Vector2();
  const ray = new Raycaster();
  ray.setFromCamera(at, view.camera);
  const [hit] = ray.intersectObjects(world.byNumber.map((body) => body.finest.solid), false);
  const body = hit && world.byNumber.find((one) => one.finest.solid === hit.object);
  if (!body?.about.moves) return null;
  return { name: body.about.name, point: body.group.worldToLocal(hit.point.clone()).toArray() };
}
