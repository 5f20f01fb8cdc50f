// Signs on buttons, drawn on 24 x 24.
const PATHS = {
  pause: "M8 5v14M16 5v14", play: "M8 5l11 7-11 7z", step: "M6 5l8 7-8 7zM18 5v14", reset: "M5 12a7 7 0 1 0 2.3-5.2M5 4v4.5h4.5",
  record: "M12 12m-5.5 0a5.5 5.5 0 1 0 11 0a5.5 5.5 0 1 0-11 0", stop: "M7 7h10v10H7z",
  theme: "M12 4a8 8 0 1 0 0 16zM12 4a8 8 0 0 1 0 16", help: "M9 9a3 3 0 1 1 4.2 2.75c-.8.4-1.2 1-1.2 2.25M12 17.5v.5",
  fit: "M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5",
  levels: "M12 4l8 14H4zM8 11h8M12 4v14", ghost: "M6 20V10a6 6 0 0 1 12 0v10l-3-2-3 2-3-2zM10 10v.5M14 10v.5",
  contacts: "M4 16h16M8 16v-6M16 16v-6M6 12l2-2.5 2 2.5M14 12l2-2.5 2 2.5", forces: "M5 19L19 5M19 5h-7M19 5v7",
  sound: "M4 10v4h3l5 4V6l-5 4zM15.5 9a4 4 0 0 1 0 6M18 6.5a8 8 0 0 1 0 11",
  names: "M4 5h9l7 7-7 7H4zM8 12h.5",
  open: "M3 18V6h6l2 2.5h10V18z",
  headset: "M3 8.5A1.5 1.5 0 0 1 4.5 7h15A1.5 1.5 0 0 1 21 8.5v7a1.5 1.5 0 0 1-1.5 1.5H16l-2.5-2.5h-3L8 17H4.5A1.5 1.5 0 0 1 3 15.5zM7.5 11.5h2M14.5 11.5h2",
  room: "M3 8.5A1.5 1.5 0 0 1 4.5 7h15A1.5 1.5 0 0 1 21 8.5v7a1.5 1.5 0 0 1-1.5 1.5H16l-2.5-2.5h-3L8 17H4.5A1.5 1.5 0 0 1 3 15.5zM12 3v2M12 19v2",
  add: "M12 5v14M5 12h14", remove: "M5 12h14",
  save: "M12 4v11M7 11l5 5 5-5M5 20h14",
  hand: "M8 12V6a1.5 1.5 0 0 1 3 0v5V4.5a1.5 1.5 0 0 1 3 0V11V6a1.5 1.5 0 0 1 3 0v8c0 4-2 6-5.5 6S7 18 6 15l-1-2.5c-.5-1.5 1.5-2.3 2.2-1z",
};

export function icon(name) {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 24 24");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", PATHS[name]);
  svg.append(path);
  return svg;
}

/// A button with a sign; its name is read out and shown when pointed at.
export function iconButton(name, label, key, pressed) {
  const button = Object.assign(document.createElement("button"), { type: "button", className: `icon ${name}` });
  button.append(icon(name));
  nameButton(button, label, key);
  button.addEventListener("click", () => pressed(button));
  return button;
}

export function nameButton(button, label, key) {
  button.title = key ? `${label} (${key})` : label;
  button.setAttribute("aria-label", label);
}

export function setIcon(button, name) {
  if (button.dataset.icon === name) return;
  button.dataset.icon = name;
  button.replaceChildren(icon(name));
}
