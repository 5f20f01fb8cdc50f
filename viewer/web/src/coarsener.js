// The page's second worker: makes coarser surfaces (coarsen.js), which takes longer than a page may stand still.
import { coarsen } from "./coarsen.js";

onmessage = ({ data: { body, mesh, tolerances } }) => coarsen(mesh, tolerances, (surface, deviation) => {
  postMessage({ body, surface, deviation }, Object.values(surface).map(({ buffer }) => buffer));
});
