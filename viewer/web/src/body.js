// One object with the surfaces of its levels: which of them is drawn, and where contacts colour it.
import { coarsestWithin, levelAtHand, levelToDraw } from "./detail.js";
import { disposeSurface, makeSurface, markSurface, paintSurface, shadeSurface, showParts, thinSpots, tintPatches } from "./surface.js";

/// mesh    decoded `mesh`; about   its entry in `scene`
export function makeBody(mesh, about) {
  const finest = makeSurface(mesh);
  return { group: finest.group, geometry: finest.geometry, finest, about, levels: new Map(), coarse: null, relief: null, browsed: null, wireframe: false,
    drawn: 0, rich: true, colours: null };
}

/// Whether a level has a surface of its own that is not here yet.
export function lacksLevel(body, level) {
  return level > 0 && !body.levels.has(level) && hasSurface(body, level);
}

export function hasSurface({ about }, level) {
  const entry = about.level_list?.[level];
  return Boolean(entry) && !entry.free && entry.triangles > 0;
}

/// message   decoded `level`
export function addLevel(body, message) {
  if (body.levels.has(message.level)) return;
  addSurface(body, message.level, makeSurface(message, body.finest.ranges));
}

function addSurface(body, level, surface) {
  body.levels.set(level, surface);
  body.group.add(surface.group);
  if (body.colours) paintSurface(surface, body.colours);
  shadeSurface(surface, body.rich);
  arrange(body);
}

/// What level 0 is felt as: its triangles divided and displaced, by the patches of level 0. `message` decoded `relief`.
export function addRelief(body, message) {
  const { nodeOfPatch, parents, levels } = body.finest.mesh;
  if (body.relief || message.patches !== nodeOfPatch.length) return;
  body.relief = makeSurface({ ...message, nodeOfPatch, parents, levels }, body.finest.ranges);
  body.group.add(body.relief.group);
  if (body.colours) paintSurface(body.relief, body.colours);
  shadeSurface(body.relief, body.rich);
  arrange(body);
}

/// colours   {base, line, sky}
export function paintBody(body, colours) {
  body.colours = colours;
  for (const surface of surfaces(body)) paintSurface(surface, colours);
}

export function shadeBody(body, rich) {
  body.rich = rich;
  for (const surface of surfaces(body)) shadeSurface(surface, rich);
}

const surfaces = (body) => [body.finest, ...body.levels.values(), ...(body.relief ? [body.relief] : [])];
const surfaceOf = (body, level) => body.levels.get(level) ?? body.finest;

/// wireframe   the finest resolution as lines and only what is active as surface (Fig. 3.1)
/// browsed     level whose patches are shown, null: none
export function showBody(body, { wireframe = body.wireframe, browsed = body.browsed }) {
  Object.assign(body, { wireframe, browsed });
  arrange(body);
}

const FEWEST = 4000; // triangles; fewer are drawn as they are
const COARSER = Array.from({ length: 10 }, (_, k) => 6e-4 * 1.5 ** k); // of the object's radius: how far surfaces made here may be off

/// How far off coarser surfaces for drawing alone would be [m], finest first; null where the object needs none, or they were
/// asked for already.
/// allowed   how far what is drawn may be off [m]
export function wantedCoarser(body, allowed) {
  const { radius, triangles } = body.about;
  if (body.coarse || triangles < FEWEST || allowed < COARSER[0] * radius) return null;
  body.coarse = [];
  return COARSER.map((share) => share * radius);
}

/// One of them has come, the finer ones before. surface   {positions, triangles, patchOfTriangle}
export function addCoarser(body, surface, deviation) {
  body.coarse.push({ mesh: { ...body.finest.mesh, ...surface }, deviation, triangles: surface.triangles.length / 3 });
}

/// The level whose surface is nowhere farther off than allowed and has the fewest triangles: of the asset, or with a number
/// below 0 one made for drawing alone.
/// metres, pixels   of one of them, and how many are allowed
export function levelFor(body, metres, pixels) {
  const { level_list: list, triangles } = body.about;
  const level = levelToDraw(list, metres, pixels), made = coarsestWithin(body.coarse ?? [], pixels * metres);
  if (made === 0 || (list?.[level]?.triangles ?? triangles) <= body.coarse[-1 - made].triangles) return level;
  if (!body.levels.has(made)) addSurface(body, made, makeSurface(body.coarse[-1 - made].mesh, body.finest.ranges));
  return made;
}

/// Draws the object by the surface of a level, or by the nearest finer one that is here; true when that changed.
export function drawLevel(body, wanted) {
  const level = wanted < 0 ? wanted : levelAtHand(wanted, (one) => body.levels.has(one));
  if (level === body.drawn) return false;
  body.drawn = level;
  arrange(body);
  return true;
}

/// The surface of a level, without relief; of the finest where it is not here.
export const smoothSurface = (body, level = body.drawn) => surfaceOf(body, level);

/// The surface that shows the object as it is.
const shownSurface = (body) => (body.drawn === 0 && body.relief ? body.relief : smoothSurface(body));

/// Relief and what is made for drawing alone is only for the whole.
const isLevel = (body, surface) => surface !== body.relief && ![...body.levels].some(([level, own]) => level < 0 && own === surface);

/// Of the surfaces one is whole, or each is where its level is active.
function arrange(body) {
  const { browsed, wireframe } = body;
  const whole = browsed === null ? (wireframe ? null : shownSurface(body)) : surfaceOf(body, browsed);
  for (const surface of surfaces(body)) {
    const isBrowsed = browsed !== null && surface === whole;
    tintPatches(surface, isBrowsed ? browsed : null);
    const solid = surface === whole ? "whole" : whole === null && isLevel(body, surface) ? "active" : "none";
    showParts(surface, solid, isBrowsed ? 0.3 : wireframe && browsed === null && surface === body.finest ? 0.16 : 0);
  }
}

/// contacts   [{point: [x, y, z] in the mesh frame, node, level}] on this body
/// size       of the scene's object [m]
export function markContacts(body, contacts, size) {
  const apart = 0.03 * size, reach = 0.075 * size;
  const own = (level) => body.levels.get(level);
  const isOne = body.browsed === null && !body.wireframe; // a single surface shows the contacts of all levels
  // Else each level shows its own where its surface is there, and the finest the others.
  for (const surface of surfaces(body)) {
    const isMine = ({ level }) => (isOne ? surface === shownSurface(body)
      : surface === body.finest ? !own(level) || body.browsed !== null : surface === own(level));
    const mine = contacts.filter(isMine);
    markSurface(surface, mine, thinSpots(mine, apart), reach, isOne ? 2 * reach : Infinity);
  }
}

export function disposeBody(body) {
  for (const surface of surfaces(body)) disposeSurface(surface);
}
