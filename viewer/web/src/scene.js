// The picture: both objects, ground and shadow, the ghost of the hand, contacts, arrows. Everything lies in `root`, in
// metres; root is scaled so that the scene has radius 1 whatever its size, nanometres or kilometres.
import { Group, NeutralToneMapping, PCFShadowMap, Scene, SRGBColorSpace, Vector3, WebGLRenderer } from "three";
import { depthOf, makeView, placeCamera, unitsPerPixel } from "./camera.js";
import { boundsOf } from "./geometry.js";
import { apart, makeGhost, paintGhost, shapeGhost } from "./ghost.js";
import { addGround, addLights } from "./lights.js";
import { makeArrow, makeContactMarks, makeRod, makeTwist, paintArrow, paintRod, paintTwist, setArrow, setContactMarks,
  setRod, setTwist } from "./marks.js";
import { makeRowMarks, setRowMarks } from "./rowmarks.js";
import { STATE } from "./protocol.js";
import { addCoarser, addLevel, addRelief, disposeBody, drawLevel, lacksLevel, levelFor, makeBody, markContacts, paintBody, shadeBody, showBody,
  smoothSurface, wantedCoarser } from "./body.js";
import { beginAgain, makePace, notePicture, PLAIN_STEP, restAfter, STEPS } from "./pace.js";
import { colour } from "./theme.js";
import { makeWorld, paintWorld, placeBodies } from "./world.js";

export const EMPHASIS = 1.6; // the arrow has to come out of the object it starts in

/// Whether pictures are made by the processor, which the engine needs as well.
function drawsInSoftware() {
  const gl = document.createElement("canvas").getContext("webgl2");
  const names = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

/// canvas   where to draw; throws when there is no WebGL 2
/// asked    "full": all of the picture however long it takes; "plain": as for computers without graphics hardware; else
///          whatever the graphics can do
export function makeScene(canvas, asked = null) {
  const plain = asked === "plain" || (asked !== "full" && drawsInSoftware());
  const renderer = new WebGLRenderer({ canvas, antialias: !plain, alpha: true, powerPreference: "high-performance" });
  renderer.outputColorSpace = SRGBColorSpace;
  renderer.toneMapping = NeutralToneMapping;
  renderer.debug.checkShaderErrors = !plain; // asking waits for the compiler
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.shadowMap.autoUpdate = false; // only when something has moved, not when the view turns
  const scene = new Scene();
  const root = new Group();
  scene.add(root);
  const markLight = plain ? { value: 1 } : null;
  const stage = {
    canvas, renderer, scene, root, view: makeView(), plain, lights: addLights(scene), ground: addGround(scene), radius: 1,
    size: 1, object: null, statics: [], world: null, ghost: null, force: makeArrow(markLight), twist: makeTwist(markLight),
    marks: makeContactMarks(markLight), rows: makeRowMarks(markLight), spring: makeRod(markLight), markLight, dirty: true, options: { wireframe: false, ghost: true, contacts: true, forces: true, names: true },
    editing: false, start: null, wants: () => {}, done: () => {}, wanted: new Set(), last: null, moved: true, resized: true, fence: null, begun: 0, rested: 0, isSeen: false, coarsener: null,
    pace: makePace({ step: plain ? PLAIN_STEP : 0, fixed: asked === "full" }),
  };
  root.add(stage.force.group, stage.twist.group, stage.marks.group, stage.rows.group, stage.spring.group);
  stage.spring.group.visible = false;
  return stage;
}

/// The objects of a `scene` message with their meshes by number.
/// keeps   the same objects with other levels of detail: the view stays, and where they are
export function setObjects(stage, description, meshes, keeps = false) {
  const last = keeps ? stage.last : null; // of a world the bodies are where the description has them
  for (const body of bodies(stage)) {
    stage.root.remove(body.group);
    disposeBody(body);
  }
  if (stage.ghost) stage.root.remove(stage.ghost.group);
  stage.coarsener?.terminate(); // its objects go
  stage.coarsener = stage.last = null;
  stage.isSeen = false; // no picture of them is done yet
  stage.start = { position: description.start.position, quaternion: description.start.quat_xyzw };
  hideMarks(stage); // until there is something to show
  stage.object = makeBody(meshes.get(description.object.mesh), description.object);
  stage.statics = description.statics.map((entry) => {
    const body = makeBody(meshes.get(entry.mesh), entry);
    place(body.group, { position: entry.position, quaternion: entry.quat_xyzw });
    return body;
  });
  stage.world = makeWorld(description, bodies(stage));
  for (const body of bodies(stage)) {
    showBody(body, { wireframe: stage.options.wireframe });
    shadeBody(body, STEPS[stage.pace.step].rich);
  }
  stage.ghost = makeGhost(stage.object.geometry);
  place(stage.object.group, stage.start);
  stage.root.add(stage.object.group, ...stage.statics.map((surface) => surface.group), stage.ghost.group);
  stage.size = description.object.radius;
  stage.wanted.clear();
  if (!keeps) fit(stage);
  stage.moved = true;
  repaint(stage);
  if (last) showSnapshot(stage, last);
}

function hideMarks(stage) {
  for (const { group } of [stage.force, stage.twist, stage.spring]) group.visible = false;
  setContactMarks(stage.marks, [], [], 1, colour("ring"));
  setRowMarks(stage.rows, [], { size: 1, longest: 1 }, { near: colour("contact"), press: colour("press") });
}

/// While a scene is being put together its object is shown where it starts, whatever the session does with it.
export function setEditing(stage, isOn) {
  if (stage.editing === isOn) return;
  stage.editing = isOn;
  if (!stage.object) return;
  if (!isOn && stage.last) { showSnapshot(stage, stage.last); return; }
  hideMarks(stage);
  stage.ghost.group.visible = false;
  for (const body of bodies(stage)) markContacts(body, [], stage.size);
  place(stage.object.group, stage.start);
  stage.dirty = stage.moved = true;
}

/// The one in the hand first; empty before the first scene.
export const bodies = (stage) => (stage.object ? [stage.object, ...stage.statics] : []);

/// A `level` message has come.
export function takeLevel(stage, message) {
  for (const body of bodies(stage)) if (body.about.mesh === message.number) addLevel(body, message);
  if (stage.last) showContacts(stage, stage.last);
  stage.dirty = stage.moved = true;
}

/// A `relief` message has come.
export function takeRelief(stage, message) {
  for (const body of bodies(stage)) if (body.about.mesh === message.number) addRelief(body, message);
  if (stage.last) showContacts(stage, stage.last);
  stage.dirty = stage.moved = true;
}

/// Shows the patches of a level of one body, or with null the body as it is.
export function browseLevel(stage, body, level) {
  showBody(body, { browsed: level });
  if (level !== null) want(stage, body, level);
  if (stage.last) showContacts(stage, stage.last);
  stage.dirty = stage.moved = true;
}

const GLASS = 3; // times as far as the object the ghost may be off
const AGAIN = 1000; // after which a refused level is asked for again [ms]

/// Asks for the surface of a level, once; again where the program had no room for it.
async function want(stage, body, level) {
  const key = `${body.about.mesh} ${level}`, { wanted } = stage;
  if (!lacksLevel(body, level) || wanted.has(key)) return;
  wanted.add(key);
  const ack = await stage.wants(body.about.mesh, level);
  if (!ack.ok) setTimeout(() => wanted.delete(key), AGAIN);
}

/// Asks for coarser surfaces of an object for drawing alone. A worker makes them; until they come the original is drawn. The
/// first picture does not wait for a processor that makes them.
function wantCoarser(stage, body, allowed) {
  if (!stage.isSeen) return;
  const tolerances = wantedCoarser(body, allowed);
  if (!tolerances) return;
  stage.coarsener ??= Object.assign(new Worker("coarsener.js"), { onmessage: ({ data }) => takeCoarser(stage, data) });
  const { positions, triangles, patchOfTriangle } = body.finest.mesh;
  stage.coarsener.postMessage({ body: bodies(stage).indexOf(body), mesh: { positions, triangles, patchOfTriangle }, tolerances });
}

function takeCoarser(stage, { body, surface, deviation }) {
  addCoarser(bodies(stage)[body], surface, deviation);
  beginAgain(stage.pace);
  stage.resized = stage.dirty = true;
}

/// Each object as finely as the step of the pace asks, from where one looks.
function chooseLevels(stage) {
  const { off } = STEPS[stage.pace.step];
  const at = new Vector3();
  let changed = false;
  for (const body of bodies(stage)) {
    const { center, radius, relief } = body.about;
    stage.root.localToWorld(at.set(...center).applyQuaternion(body.group.quaternion).add(body.group.position));
    const nearest = Math.max(stage.view.camera.near, depthOf(stage.view, at) - radius / stage.radius);
    const metres = unitsPerPixel(stage.view, nearest, stage.canvas.clientHeight) * stage.radius;
    const pixels = off - (relief ?? 0) / metres; // a level has none of it
    wantCoarser(stage, body, pixels * metres);
    const level = levelFor(body, metres, pixels);
    want(stage, body, level);
    changed = drawLevel(body, level) || changed;
    if (body !== (stage.world?.shown ?? stage.object)) continue;
    const glass = levelFor(body, metres, GLASS * off); // which shows no relief, and little else
    want(stage, body, glass);
    shapeGhost(stage.ghost, smoothSurface(body, glass).geometry);
  }
  if (changed && stage.last) showContacts(stage, stage.last);
}

function place(group, pose) {
  group.position.fromArray(pose.position);
  group.quaternion.fromArray(pose.quaternion);
}

/// Centre and scale of the whole scene, from the boxes of its surfaces as they stand.
function fit(stage) {
  const points = [];
  for (const { group, geometry } of [stage.object, ...stage.statics]) {
    const box = boundsOf(geometry.attributes.position.array);
    group.updateMatrix();
    for (let corner = 0; corner < 8; corner++) {
      const at = [0, 1, 2].map((k) => (corner & (1 << k) ? box.max[k] : box.min[k]));
      points.push(...new Vector3(...at).applyMatrix4(group.matrix).toArray());
    }
  }
  const box = boundsOf(points);
  stage.radius = box.radius > 0 ? box.radius : 1;
  stage.root.scale.setScalar(1 / stage.radius);
  stage.root.position.fromArray(box.center).multiplyScalar(-1 / stage.radius);
  stage.ground.position.z = (box.min[2] - box.center[2]) / stage.radius - 0.012;
  stage.root.updateMatrixWorld();
}

export function repaint(stage) {
  const sky = Number(colour("sky"));
  if (stage.object) {
    paintBody(stage.object, { base: colour("held"), line: colour("held-line"), sky });
    for (const body of stage.statics) paintBody(body, { base: colour("fixed"), line: colour("fixed-line"), sky });
    if (stage.world) paintWorld(stage.world, sky);
    paintGhost(stage.ghost, colour("ghost"));
  }
  paintArrow(stage.force, colour("force"));
  paintTwist(stage.twist, colour("torque"));
  paintRod(stage.spring, colour("hand"));
  stage.ground.material.opacity = Number(colour("shadow"));
  stage.lights.sky.intensity = sky;
  if (stage.markLight) stage.markLight.value = sky;
  stage.dirty = true;
}

/// Shows a snapshot; in a world where all bodies are, as the newest `bodies` has them, null: not known yet.
export function showSnapshot(stage, snapshot, world = null) {
  if (!stage.object) return;
  stage.last = snapshot;
  if (stage.editing) return;
  if (!stage.world) place(stage.object.group, snapshot.object);
  else if (world) placeBodies(stage.world, world, Number(colour("sky")));
  place(stage.ghost.group, snapshot.ghost);
  const grasped = (snapshot.bits & 1) !== 0;
  const at = new Vector3(...snapshot.grasp), hand = new Vector3(...snapshot.handle.position);
  stage.ghost.group.visible = stage.options.ghost && grasped && apart(snapshot, stage.size) > 0.004;
  stage.spring.group.visible = stage.options.ghost && grasped;
  setRod(stage.spring, at, hand, 0.012 * stage.size);
  showForces(stage, snapshot, at);
  showContacts(stage, snapshot);
  stage.dirty = stage.moved = true;
}

function showForces(stage, snapshot, at) {
  if (!stage.options.forces) {
    stage.force.group.visible = stage.twist.group.visible = false;
    return;
  }
  const perNewton = snapshot.metresPerNewton > 0 ? snapshot.metresPerNewton : 0.5 * stage.size;
  const along = new Vector3(...snapshot.force).multiplyScalar(EMPHASIS * perNewton);
  along.clampLength(0, 4 * stage.size);
  setArrow(stage.force, at, along, 0.045 * stage.size);
  const axis = new Vector3(...snapshot.torque);
  const whole = (0.5 * stage.size * stage.size) / perNewton; // an arrow as long as the object at half its radius
  setTwist(stage.twist, at, axis, axis.length() / whole, 0.42 * stage.size);
}

function showContacts(stage, snapshot) {
  if (stage.editing) return;
  const constrained = (snapshot.bits & STATE.constrained) !== 0; // rows stand for contacts then
  const shown = stage.options.contacts && !constrained ? snapshot.contacts : [];
  setRowMarks(stage.rows, stage.options.contacts ? snapshot.rows : [], { size: 0.045 * stage.size, longest: 0.34 * stage.size },
    { near: colour("contact"), press: colour("press") });
  if (stage.world) return; // which has rows alone
  const largest = Math.max(1e-30, ...snapshot.clusters.map((cluster) => Math.hypot(...cluster.force)));
  setContactMarks(stage.marks,
    shown.map((contact) => ({ point: contact.point, normal: contact.normal, level: contact.objectLevel })),
    stage.options.contacts ? snapshot.clusters.map((cluster) => ({ point: cluster.point, normal: cluster.normal,
      share: Math.hypot(...cluster.force) / largest })) : [], 0.011 * stage.size, colour("ring"));
  const mark = (body, of) => {
    markContacts(body, of.map(({ point, node, level }) => ({ point: toMesh(body.group, point), node, level })), stage.size);
    if (body.wireframe) for (const { level } of of) want(stage, body, level);
  };
  const coloured = constrained && stage.object.about.levels <= 1 ? [] : snapshot.contacts; // one level tells nothing, and hides the rows
  mark(stage.object, coloured.map((c) => ({ point: c.point, node: c.objectNode, level: c.objectLevel })));
  stage.statics.forEach((body, number) => mark(body, coloured.filter((contact) => contact.body === number)
    .map((c) => ({ point: c.point, node: c.sceneNode, level: c.sceneLevel }))));
}

function toMesh(group, point) {
  return new Vector3(...point).sub(group.position).applyQuaternion(group.quaternion.clone().conjugate()).toArray();
}

/// options   any of {wireframe, ghost, contacts, forces, names}
export function setOptions(stage, options) {
  Object.assign(stage.options, options);
  for (const body of bodies(stage)) showBody(body, { wireframe: stage.options.wireframe });
  if (stage.last) showSnapshot(stage, stage.last);
  stage.dirty = true;
}

/// The canvas has another size in the page. Its pixels follow with the next picture: until then the last one stays.
export function resize(stage) {
  const { clientWidth: width, clientHeight: height } = stage.canvas;
  if (width === 0 || height === 0 || stage.renderer.xr.isPresenting) return; // a headset has its own
  stage.resized = true;
  stage.view.camera.aspect = width / height;
  stage.view.camera.fov = width < height ? 38 : 30; // an upright picture would cut the sides off
  stage.view.camera.updateProjectionMatrix();
  placeCamera(stage.view);
}

/// The picture is as large as the view, however slow; where there are no shadows, nothing to catch them.
function setQuality(stage) {
  const { clientWidth: width, clientHeight: height } = stage.canvas;
  const { pixels, shadows, rich } = STEPS[stage.pace.step];
  stage.renderer.setPixelRatio(stage.plain ? 1 : Math.min(pixels, devicePixelRatio));
  if (width > 0 && height > 0) stage.renderer.setSize(width, height, false);
  stage.lights.key.castShadow = stage.ground.visible = shadows;
  for (const body of bodies(stage)) shadeBody(body, rich);
  stage.resized = false;
  stage.moved = true;
}

/// Whether the last picture is done and the machine has had its rest. Handing over more pictures than the graphics can make
/// would in the end hold up this thread, and with it the hand. Where a picture takes long, pictures get half of the time, as
/// the engine and the page need the rest, and the next ones are simpler.
export const isReady = (stage) => isDone(stage) && performance.now() >= stage.rested;

function isDone(stage) {
  if (!stage.fence) return true;
  const gl = stage.renderer.getContext(), now = performance.now();
  if (!gl.isContextLost()) {
    if (gl.getSyncParameter(stage.fence, gl.SYNC_STATUS) !== gl.SIGNALED) return false;
    gl.deleteSync(stage.fence);
    const took = 1e-3 * (now - stage.begun);
    stage.rested = now + 1e3 * restAfter(took, stage.plain);
    stage.resized ||= notePicture(stage.pace, took);
    stage.dirty ||= !stage.isSeen; // so that coarser surfaces are asked for
    stage.isSeen = true;
  }
  stage.fence = null;
  return true;
}

/// Looks when the picture is done: frames of the browser come too seldom to tell how long it took.
function watch(stage) {
  if (!isDone(stage)) setTimeout(watch, LOOK, stage);
  else stage.done(stage.rested - performance.now());
}
const LOOK = 4; // [ms]

/// Draws when something has changed; true when it did. Only where isReady.
export function draw(stage) {
  if (!(stage.dirty || stage.view.changed)) return false;
  const gl = stage.renderer.getContext();
  if (stage.resized) setQuality(stage);
  chooseLevels(stage);
  stage.dirty = stage.view.changed = false;
  stage.renderer.shadowMap.needsUpdate = stage.moved;
  stage.moved = false;
  stage.begun = performance.now();
  stage.renderer.render(stage.scene, stage.view.camera);
  stage.fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  setTimeout(watch, LOOK, stage);
  return true;
}

/// Metres one pixel of a drag stands for, at the depth of a point of the world.
export function metresPerPixel(stage, point) {
  const shown = stage.root.localToWorld(new Vector3(...point));
  const tangent = Math.tan((stage.view.camera.fov * Math.PI) / 360);
  return (2 * tangent * depthOf(stage.view, shown) * stage.radius) / Math.max(1, stage.canvas.clientHeight);
}
