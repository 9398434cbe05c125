// What is under the pointer in one view, or has the focus, is marked in all: elements that have the
// same value of an attribute, such as data-contact, get the class `lit`.
const lit = {};

// `follow` is called after the marks have changed.
function linkViews(names, follow = () => {}) {
  for (const name of names) lit[name] = null;
  const show = (event) => {
    const found = event.target.closest?.(names.map((name) => `[data-${name}]`).join());
    const now = names.map((name) => found?.dataset[name] ?? null);
    if (names.every((name, k) => lit[name] === now[k])) return;
    names.forEach((name, k) => { lit[name] = now[k]; });
    highlight();
    follow();
  };
  document.addEventListener("pointerover", show);
  document.addEventListener("focusin", show);
}

// `also` lists what is marked besides, as pairs of an attribute's name and its value.
function highlight(also = []) {
  for (const name of Object.keys(lit)) {
    const values = [lit[name], ...also.filter(([other]) => other === name).map(([, value]) => value)];
    document.querySelectorAll(`[data-${name}]`).forEach((/** @type {HTMLElement} */ e) => e.classList.toggle("lit", values.includes(e.dataset[name])));
  }
}
