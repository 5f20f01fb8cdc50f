// Light and dark: the style sheet holds the colours, the scene and the plots read them from there.

const KEY = "thigma-theme";

export function currentTheme() {
  const chosen = document.documentElement.dataset.theme;
  if (chosen) return chosen;
  return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

/// Applies what was chosen before, and tells `changed` whenever the colours change.
export function startTheme(changed) {
  let kept = null;
  try { kept = localStorage.getItem(KEY); } catch { /* storage may be denied: the system's theme then */ }
  if (kept === "light" || kept === "dark") document.documentElement.dataset.theme = kept;
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => changed());
  return function toggle() {
    const next = currentTheme() === "dark" ? "light" : "dark";
    document.documentElement.dataset.theme = next;
    try { localStorage.setItem(KEY, next); } catch { /* as above */ }
    changed();
  };
}

/// Value of a custom property of the style sheet.
export function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

/// Colour of a level of detail: 0, the original surface, is the darkest green, coarser ones turn yellow and red, away from the
/// blue of the object and the bone of the scene.
export const LEVEL_COLOURS = ["#0a8f83", "#23ab6a", "#7cc542", "#bdd334", "#e6d32e", "#f5a32b", "#ea7430", "#d64a45"];
export function levelColour(level) {
  return LEVEL_COLOURS[Math.max(0, Math.min(LEVEL_COLOURS.length - 1, level))];
}
