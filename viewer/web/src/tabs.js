// Tabs of the panel: by mouse, or by arrow keys while one of them has the keyboard.

/// tabs      [[id of the page, name]]
/// chosen    told of the one that is shown
export function startTabs(parent, tabs, told = () => {}) {
  const made = tabs.map(([id, name]) => {
    const tab = Object.assign(document.createElement("button"), { type: "button", textContent: name });
    tab.setAttribute("role", "tab");
    tab.setAttribute("aria-controls", id);
    tab.addEventListener("click", () => choose(id));
    return { id, tab };
  });
  function choose(chosen) {
    for (const { id, tab } of made) {
      tab.setAttribute("aria-selected", String(id === chosen));
      tab.tabIndex = id === chosen ? 0 : -1;
      document.getElementById(id).hidden = id !== chosen;
    }
    told(chosen);
  }
  parent.addEventListener("keydown", ({ key }) => {
    const way = { ArrowRight: 1, ArrowLeft: -1 }[key];
    const at = made.findIndex(({ tab }) => tab === document.activeElement);
    if (!way || at < 0) return;
    const next = made[(at + way + made.length) % made.length];
    choose(next.id);
    next.tab.focus();
  });
  parent.append(...made.map(({ tab }) => tab));
  choose(tabs[0][0]);
  return choose;
}
