// What stands over the picture while there is none, or none that counts.

/// A sentence over the picture, perhaps with how far something is and a way to give it up; null takes it away.
export function veil(sentence, share = null, cancel = null) {
  const box = document.getElementById("veil");
  box.hidden = !sentence;
  box.classList.toggle("working", share !== null);
  if (!sentence) { box.replaceChildren(); return; }
  if (share !== null && box.querySelector("progress")) { // the button that has the keyboard stays
    box.querySelector("p").textContent = sentence;
    box.querySelector("progress").value = share;
    return;
  }
  const text = Object.assign(document.createElement("p"), { textContent: sentence });
  const bar = Object.assign(document.createElement("progress"), { max: 1, value: share ?? 0 });
  bar.setAttribute("aria-label", "How far it is");
  const stop = Object.assign(document.createElement("button"), { type: "button", className: "primary", textContent: "Cancel" });
  stop.addEventListener("click", cancel ?? (() => {}));
  box.replaceChildren(text, ...(share === null ? [] : [bar]), ...(cancel ? [stop] : []));
}
