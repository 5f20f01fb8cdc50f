// What measures the picture: axes that turn the view, a scale bar, the length of an arrow, the names of the objects.
import { Vector3 } from "three";
import { axes, depthOf, unitsPerPixel } from "./camera.js";
import { bodies, EMPHASIS } from "./scene.js";
import { roundLength } from "./geometry.js";
import { say } from "./format.js";
import { element } from "./dom.js";

const REACH = 26; // of an axis [px]
const WIDEST = 110; // of a bar [px]
export const PRESETS = [["1", "+x", [1, 0, 0]], ["2", "-x", [-1, 0, 0]], ["3", "+y", [0, 1, 0]], ["4", "-y", [0, -1, 0]],
  ["5", "+z", [0, 0, 1]], ["6", "-z", [0, 0, -1]]]; // key, name, where the eye is

/// look   (direction) turns the view
export function makeRulers(parent, names, look) {
  const compass = element("div", "compass"), lines = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  compass.setAttribute("role", "group");
  compass.setAttribute("aria-label", "Views along the axes");
  lines.setAttribute("viewBox", "-36 -36 72 72");
  lines.setAttribute("aria-hidden", "true");
  compass.append(lines);
  const ends = PRESETS.map(([key, name, way]) => {
    const line = document.createElementNS("http://www.w3.org/2000/svg", "line");
    const button = Object.assign(element("button", `axis axis-${name[1]} ${name[0] === "+" ? "plus" : "minus"}`, name[0] === "+" ? name[1] : ""), { type: "button", title: `View from ${name} (${key})` });
    button.setAttribute("aria-label", `View from ${name}`);
    button.addEventListener("click", () => look(way));
    line.classList.add(`axis-${name[1]}`);
    if (name[0] === "+") lines.append(line);
    compass.append(button);
    return { way: new Vector3(...way), line, button };
  });
  const bar = (className) => {
    const box = element("div", `ruler ${className}`), text = element("span"), length = element("i");
    box.append(text, length);
    return { box, text, length };
  };
  const rulers = { parent, names, ends, scale: bar("ruler-scale"), force: bar("ruler-force"), tags: [] };
  parent.replaceChildren(rulers.force.box, rulers.scale.box, compass);
  return rulers;
}

/// After each picture.
/// snapshot   may be null; options   of the stage
export function showRulers(rulers, stage, snapshot) {
  const { view, options, canvas: { clientWidth: width, clientHeight: height } } = stage; // before anything is written
  if (!stage.object || height === 0) return;
  const { right, up, forward } = axes(view);
  for (const { way, line, button } of rulers.ends) {
    const x = REACH * way.dot(right), y = -REACH * way.dot(up);
    line.setAttribute("x2", x.toFixed(1));
    line.setAttribute("y2", y.toFixed(1));
    button.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    button.style.zIndex = way.dot(forward) < 0 ? 2 : 1;
  }
  const centre = stage.root.localToWorld(stage.object.group.position.clone());
  const metres = unitsPerPixel(view, depthOf(view, centre), height) * stage.radius; // of a pixel at the object
  setBar(rulers.scale, metres, "m", 1e-9);
  const perNewton = snapshot?.metresPerNewton;
  rulers.force.box.hidden = !(perNewton > 0) || !options.forces;
  if (perNewton > 0) setBar(rulers.force, metres / (EMPHASIS * perNewton), "N", 1e-6);
  showNames(rulers, stage, up, width, height);
}

/// perPixel   of the unit
function setBar({ text, length }, perPixel, unit, least) {
  const whole = roundLength(WIDEST * perPixel);
  const words = say(whole, unit, least).replace(/\.0+(?= )/, "");
  if (text.textContent !== words) text.textContent = words;
  length.style.width = `${(whole / perPixel).toFixed(1)}px`;
}

const FEW = 12; // bodies of a world that all have their names; of more only those in hands

function namedBodies(stage) {
  const { world } = stage;
  if (!world) return bodies(stage);
  return world.byNumber.length <= FEW ? world.byNumber : world.held.map((number) => world.byNumber[number]);
}
const isAbove = (stage, body) => (stage.world ? body.about.moves : body === stage.object);

/// Above the object in the hand, below what stands still.
function showNames(rulers, stage, up, width, height) {
  const { options, view } = stage, all = namedBodies(stage);
  rulers.names.hidden = !options.names;
  if (!options.names) return;
  if (rulers.tags.length !== all.length || rulers.tags.some(({ textContent }, k) => textContent !== all[k].about.name)) {
    rulers.tags = all.map((body) => element("span", `name-tag ${isAbove(stage, body) ? "held" : "fixed"}`, body.about.name));
    rulers.names.replaceChildren(...rulers.tags);
  }
  const at = new Vector3();
  all.forEach((body, k) => {
    const { about, group } = body;
    stage.root.localToWorld(at.set(...about.center).applyQuaternion(group.quaternion).add(group.position));
    at.addScaledVector(up, ((isAbove(stage, body) ? 0.8 : -0.8) * about.radius) / stage.radius).project(view.camera);
    const x = ((at.x + 1) / 2) * width, y = ((1 - at.y) / 2) * height;
    const isSeen = at.z < 1 && x > 0 && x < width && y > 0 && y < height;
    rulers.tags[k].style.visibility = isSeen ? "" : "hidden";
    rulers.tags[k].style.transform = `translate(${x.toFixed(0)}px, ${y.toFixed(0)}px) translate(-50%, -50%)`;
  });
}
