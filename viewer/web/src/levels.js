// The level browser: of each object any level, its patches in colours of their own (Fig. 3.1).
import { count, say } from "./format.js";
import { hasSurface } from "./body.js";
import { element } from "./dom.js";

/// browse   (number of the body, level or null): shows it
export function makeLevelBrowser(parent, browse) {
  const intro = element("p", "note", "Choose a level to see its convex patches, each in a colour of its own. What contacts use " +
    "at this moment stands in the colours of the legend.");
  const list = element("div");
  parent.append(intro, list);
  return { list, browse, rows: [], scene: null };
}

/// scene   as the program describes it: every body starts as it is
export function fillLevelBrowser(browser, scene) {
  browser.scene = scene;
  const bodies = [scene.object, ...scene.statics];
  browser.rows = bodies.map((about, body) => makeRow(browser, about, body));
  browser.list.replaceChildren(...browser.rows.map((row) => row.box));
}

function makeRow(browser, about, body) {
  const box = element("section", "level-row");
  const head = element("div", "level-head");
  const dot = element("i", body === 0 ? "held" : "fixed");
  head.append(dot, element("h2", "", about.name), element("span", "note", count(about.levels, "level")));
  const chips = element("div", "chips");
  chips.setAttribute("role", "radiogroup");
  chips.setAttribute("aria-label", `Level of the ${about.name}`);
  const caption = element("p", "note");
  const row = { box, about, body, caption, chips: [], level: null };
  const choices = [null, ...(about.level_list ?? []).keys()];
  for (const level of choices) {
    const chip = Object.assign(element("button", "chip-button", level === null ? "as it is" : String(level)), { type: "button" });
    chip.setAttribute("role", "radio");
    chip.setAttribute("aria-label", level === null ? `${about.name} as it is` : `${about.name}, level ${level}`);
    if (level !== null && level > 0 && about.level_list[level].free) chip.classList.add("free");
    chip.addEventListener("click", () => choose(browser, row, level));
    row.chips.push({ chip, level });
    chips.append(chip);
  }
  box.append(head, chips, caption);
  choose(browser, row, null);
  return row;
}

function choose(browser, row, level) {
  const changed = row.level !== level;
  row.level = level;
  for (const { chip, level: own } of row.chips) chip.setAttribute("aria-checked", String(own === level));
  row.caption.textContent = captionOf(row.about, level);
  if (changed) browser.browse(row.body, level);
}

function captionOf(about, level) {
  if (level === null) return "";
  const entry = about.level_list[level];
  if (level === 0) return `The original surface: ${count(entry.triangles, "triangle")} in ${count(entry.patches, "convex patch", "convex patches")}.`;
  if (!hasSurface({ about }, level)) {
    return `${count(entry.patches, "group")} of patches below, merged pairwise. No surface of its own: contacts here are with convex hulls.`;
  }
  return `${count(entry.triangles, "triangle")} in ${count(entry.patches, "convex patch", "convex patches")}; nowhere more than ` +
    `${say(entry.deviation, "m", 1e-9)} off the original.`;
}

/// What is shown, for the legend: "upper jaw 3, lower jaw 2", or "".
export function browsedWords(browser) {
  return browser.rows.filter((row) => row.level !== null).map((row) => `${row.about.name} ${row.level}`).join(", ");
}
