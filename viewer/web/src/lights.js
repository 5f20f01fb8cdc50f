// The lights of the picture, and the ground that catches shadows.
import { AmbientLight, Color, DirectionalLight, HemisphereLight, Mesh, PlaneGeometry, ShadowMaterial } from "three";

const linear = (hex) => new Color(hex).toArray(); // as shaders calculate

/// From over the left shoulder of who looks from the home of the view, and from behind: [world; linear colour].
export const KEY = { from: [2.3, -1.5, 3.6], colour: 0xfff4e4, tone: linear(0xfff4e4), strength: 2.6 };
export const RIM = { from: [-2.2, 2.2, 1.2], colour: 0xcfe3ff, tone: linear(0xcfe3ff), strength: 0.9 };

export function addLights(scene) {
  const sky = new HemisphereLight(0xffffff, 0x8a8378, 1.5);
  sky.position.set(0, 0, 1);
  const key = new DirectionalLight(KEY.colour, KEY.strength);
  key.position.set(...KEY.from);
  key.castShadow = true;
  key.shadow.mapSize.setScalar(1536);
  Object.assign(key.shadow.camera, { left: -1.5, right: 1.5, top: 1.5, bottom: -1.5, near: 0.5, far: 9 });
  key.shadow.radius = 4;
  key.shadow.bias = -0.0006;
  key.shadow.normalBias = 0.006;
  const rim = new DirectionalLight(RIM.colour, RIM.strength);
  rim.position.set(...RIM.from);
  const fill = new AmbientLight(0xffffff, 0.18);
  scene.add(sky, key, rim, fill);
  return { sky, key, rim, fill };
}

export function addGround(scene) {
  const shade = new Mesh(new PlaneGeometry(12, 12), new ShadowMaterial({ opacity: 0.2 }));
  shade.receiveShadow = true;
  shade.renderOrder = -1;
  scene.add(shade);
  return shade;
}
