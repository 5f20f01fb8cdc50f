// Made by tests/browser/thumbs.mjs: the scenes in the order of their pictures in scenes.webp; size: of the object in the hand [m].
export const SCENE_FACTS = {
  "ball_joint": { "size": 0.076, "triangles": 274120 },
  "block_on_gear": { "size": 0.1, "triangles": 1616 },
  "blocks": { "size": 0.1, "triangles": 32 },
  "conforming": { "size": 0.2, "triangles": 200000 },
  "cup_spoon": { "size": 0.2, "triangles": 149988 },
  "ellipsoid": { "size": 0.02, "triangles": 22002 },
  "file_on_cad": { "size": 0.2, "triangles": 1344 },
  "golf": { "size": 0.12, "triangles": 282764 },
  "hammer_on_torus": { "size": 0.24, "triangles": 1036 },
  "jaws": { "size": 0.074, "triangles": 87514 },
  "plate": { "size": 0.1, "triangles": 2016 },
  "simple_cup_spoon": { "size": 0.2, "triangles": 5340 },
  "spoon_in_cup": { "size": 0.2, "triangles": 149988 }
};
