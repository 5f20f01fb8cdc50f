// Handles of an object in the picture: axes to drag it along, rings to turn it by.
import { TransformControls } from "three/examples/jsm/controls/TransformControls.js";
import { bodies } from "./scene.js";

/// moved   ({position, quaternion}), when a drag has ended
export function makeGizmo(stage, moved) {
  const controls = new TransformControls(stage.view.camera, stage.canvas);
  const gizmo = { stage, controls, index: null, isDragging: false };
  controls.setSize(0.9);
  controls.addEventListener("change", () => { stage.dirty = true; });
  controls.addEventListener("dragging-changed", ({ value }) => {
    gizmo.isDragging = value;
    const body = bodies(stage)[gizmo.index];
    if (!value && body) moved({ position: body.group.position.toArray(), quaternion: body.group.quaternion.toArray() });
  });
  return gizmo;
}

/// Puts the handles on an object of the scene, or with null takes them away.
/// mode   "translate" or "rotate"
export function showGizmo(gizmo, index, mode) {
  const { stage, controls } = gizmo, body = index === null ? null : bodies(stage)[index];
  gizmo.index = body ? index : null;
  const helper = controls.getHelper();
  if (body) {
    controls.setMode(mode);
    controls.attach(body.group);
    stage.scene.add(helper);
  } else {
    controls.detach();
    stage.scene.remove(helper);
  }
  stage.dirty = true;
}

/// Whether a press there is for the handles, not for the view.
export function claims(gizmo, event) {
  if (gizmo.index === null || event.button !== 0) return false;
  const box = gizmo.stage.canvas.getBoundingClientRect();
  gizmo.controls.pointerHover({ x: ((event.clientX - box.left) / box.width) * 2 - 1, y: 1 - ((event.clientY - box.top) / box.height) * 2, button: event.button });
  return gizmo.controls.axis !== null;
}
