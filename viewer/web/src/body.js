// One object with the surfaces of its levels: which of them is drawn, and where contacts colour it.
import { disposeSurface, makeSurface, paintSurface, setActive, setSpots, showParts, thinSpots, tintPatches } from "./surface.js";

/// mesh    decoded `mesh`; about   its entry in `scene`
export function makeBody(mesh, about) {
  const finest = makeSurface(mesh);
  return { group: finest.group, geometry: finest.geometry, finest, about, levels: new Map(), browsed: null, wireframe: false,
    colours: null };
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
  const surface = makeSurface(message);
  body.levels.set(message.level, surface);
  body.group.add(surface.group);
  if (body.colours) paintSurface(surface, ...body.colours);
  arrange(body);
}

export function paintBody(body, base, line) {
  body.colours = [base, line];
  for (const surface of surfaces(body)) paintSurface(surface, base, line);
}

const surfaces = (body) => [body.finest, ...body.levels.values()];

/// wireframe   the finest resolution as lines and only what is active as surface (Fig. 3.1)
/// browsed     level whose patches are shown, null: none
export function showBody(body, { wireframe = body.wireframe, browsed = body.browsed }) {
  Object.assign(body, { wireframe, browsed });
  arrange(body);
}

/// Of the surfaces one is whole, or each is where its level is active.
function arrange(body) {
  const { browsed, wireframe } = body;
  const whole = browsed === null ? (wireframe ? null : body.finest) : body.levels.get(browsed) ?? body.finest;
  for (const surface of surfaces(body)) {
    const isBrowsed = browsed !== null && surface === whole;
    tintPatches(surface, isBrowsed ? browsed : null);
    const solid = surface === whole ? "whole" : whole === null ? "active" : "none";
    showParts(surface, solid, isBrowsed ? 0.3 : wireframe && browsed === null && surface === body.finest ? 0.16 : 0);
  }
}

/// contacts   [{point: [x, y, z] in the mesh frame, node, level}] on this body
/// size       of the scene's object [m]
export function markContacts(body, contacts, size) {
  const apart = 0.03 * size, reach = 0.075 * size;
  const own = (level) => body.levels.get(level);
  // Where the surface of a level is there, it shows its contacts itself; the finest shows all while it is whole.
  const isWhole = !body.wireframe || body.browsed !== null;
  for (const surface of surfaces(body)) {
    const mine = contacts.filter(({ level }) => (surface === body.finest ? isWhole || !own(level) : surface === own(level)));
    setActive(surface, mine);
    setSpots(surface, thinSpots(mine, apart), reach);
  }
}

export function disposeBody(body) {
  for (const surface of surfaces(body)) disposeSurface(surface);
}
