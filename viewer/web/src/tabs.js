// Tabs of the panel, with buttons that belong to the first.

/// tabs      [[id of the page, name]]; buttons [[name, help, act]] shown beside them
export function startTabs(parent, tabs, buttons) {
  const made = tabs.map(([id, name]) => {
    const tab = Object.assign(document.createElement("button"), { type: "button", textContent: name });
    tab.setAttribute("role", "tab");
    tab.setAttribute("aria-controls", id);
    tab.addEventListener("click", () => choose(id));
    return { id, tab };
  });
  const space = Object.assign(document.createElement("span"), { className: "grow" });
  const extras = buttons.map(([name, help, act]) => {
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: name, title: help, className: "quiet" });
    button.setAttribute("aria-label", help);
    button.addEventListener("click", act);
    return button;
  });
  function choose(chosen) {
    for (const { id, tab } of made) {
      tab.setAttribute("aria-selected", String(id === chosen));
      document.getElementById(id).hidden = id !== chosen;
    }
    for (const button of extras) button.hidden = chosen !== tabs[0][0];
  }
  parent.append(...made.map(({ tab }) => tab), space, ...extras);
  choose(tabs[0][0]);
  return choose;
}
