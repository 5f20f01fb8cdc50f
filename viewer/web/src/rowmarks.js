// Contacts that are constraints: each row as the point of one surface and the plane of the other, those that press with
// their force, friction as its cone.
import { CircleGeometry, ConeGeometry, Color, CylinderGeometry, Group, Quaternion, SphereGeometry, Vector3 } from "three";
import { clearCopies, makeCopies, putCopy, showCopies } from "./copies.js";
import { markMaterial, seenThrough, sides } from "./marks.js";

export const MAX_ROWS = 64;
const Z = new Vector3(0, 0, 1);

/// light   as of markMaterial
export function makeRowMarks(light) {
  const group = new Group();
  const shapes = {
    planes: light ? new CircleGeometry(1, 10) : new CylinderGeometry(1, 1, 0.06, 20).rotateX(Math.PI / 2),
    points: new SphereGeometry(0.36, sides(light, 8, 5), sides(light, 6, 3)),
    forces: new CylinderGeometry(0.16, 0.16, 1, sides(light, 6, 4), 1, Boolean(light)).rotateX(Math.PI / 2).translate(0, 0, 0.5),
    heads: new ConeGeometry(0.42, 1, sides(light, 12, 6)).rotateX(Math.PI / 2).translate(0, 0, 0.5),
    cones: new ConeGeometry(1, 1, sides(light, 20, 10), 1, true).translate(0, -0.5, 0).rotateX(-Math.PI / 2), // from its tip along +z
  };
  const marks = { group };
  for (const [name, shape] of Object.entries(shapes)) {
    const glass = name === "cones" || name === "planes";
    const front = markMaterial(light, glass ? { transparent: true, opacity: name === "cones" ? 0.34 : 0.72, depthWrite: false, side: 2 } : {});
    const through = seenThrough(light, { opacity: glass ? 0.16 : 0.5, side: glass ? 2 : 0 });
    marks[name] = makeCopies(group, shape, name === "points" ? 2 * MAX_ROWS : MAX_ROWS, [[front, glass ? 3 : 2], [through, 22]]);
  }
  return marks;
}

const turn = new Quaternion(), place = new Vector3(), axis = new Vector3(), scale = new Vector3(), tint = new Color();

/// rows     of a snapshot; size of a plane's radius; longest: of a force [all in the parent's units]
/// colours  {near, press}
export function setRowMarks(marks, rows, { size, longest }, colours) {
  const shown = rows.slice(0, MAX_ROWS);
  const strongest = Math.max(1e-30, ...shown.map(({ force }) => Math.hypot(...force)));
  const { group, ...kinds } = marks;
  for (const copies of Object.values(kinds)) clearCopies(copies);
  const put = (name, wide, long) => putCopy(marks[name], place, turn, scale.set(wide, wide, long), tint);
  for (const { point, normal, gap, force, friction, kind, presses } of shown) {
    tint.set(presses ? colours.press : colours.near);
    const foot = point.map((value, k) => value + gap * normal[k]); // on the scene's side
    const wide = presses ? size : 0.62 * size;
    turn.setFromUnitVectors(Z, axis.set(...normal).normalize());
    place.set(...(kind === 1 ? foot : point));
    put("points", wide, wide);
    place.set(...(kind === 1 ? point : foot));
    if (kind === 2) put("points", wide, wide); // two edges: no plane but the one along both
    else put("planes", wide, wide);
    if (!presses) continue;
    place.set(...point);
    if (friction > 0) {
      turn.setFromUnitVectors(Z, axis.set(...normal).multiplyScalar(-1).normalize()); // the way it pushes the object
      put("cones", 0.8 * longest * friction, 0.8 * longest);
    }
    const newtons = Math.hypot(...force);
    if (!(newtons > 0)) continue;
    turn.setFromUnitVectors(Z, axis.set(...force).divideScalar(newtons));
    const length = longest * (0.25 + (0.75 * newtons) / strongest), head = Math.min(1.1 * size, 0.5 * length);
    put("forces", size, length - head);
    place.addScaledVector(axis, length - head);
    put("heads", size, head);
  }
  for (const copies of Object.values(kinds)) showCopies(copies);
}
