// Pictures that turn: by drag, by keys, by themselves. What is under the pointer lights up, a click keeps it.
// A page defines state, with axes, under, kept and spinning, refresh() and goHome(). Things are known by their marks, such
// as "region-3", which are the attributes data-mark of elements.

function rotate(right, up) {
  state.axes = turnedAxes(state.axes, right, up);
  refresh();
}

function keep(chosen) {
  state.kept = chosen === state.kept ? null : chosen;
  refresh();
}

// The next or the previous one of all things of a kind.
function step(kind, number, by) {
  if (!number) return;
  const [known, id] = (state.kept ?? "").split("-");
  const start = known === kind ? Number(id) : by > 0 ? -1 : 0;
  Object.assign(state, { under: null, kept: `${kind}-${(start + by + number) % number}` });
  refresh();
}

function spin() {
  if (!state.spinning) return;
  rotate(0.006, 0);
  requestAnimationFrame(spin);
}

function underPointer(view, event) {
  const element = /** @type {HTMLElement} */ (document.elementFromPoint(event.clientX, event.clientY));
  return element && view.contains(element) ? element.dataset.mark ?? null : null;
}

/** @type {(view: SVGSVGElement, keys: Record<string, () => void>, found?: (view: Element, event: PointerEvent) => string | null) => void} */
function listenToTurns(view, keys, found = underPointer) {
  onDrag(view, {
    drag({ dx, dy }) {
      const scale = 1 / (RADIUS * view.getScreenCTM().a);
      state.under = null;
      rotate(dx * scale, dy * scale);
    },
    click: (event) => keep(found(view, event)),
  });
  const point = (under) => { if (under !== state.under) { state.under = under; refresh(); } };
  view.addEventListener("pointermove", (event) => { if (!view.classList.contains("held")) point(found(view, event)); });
  view.addEventListener("pointerleave", () => point(null));
  onKeys(view, { ...arrowKeys((x, y) => rotate(0.1 * x, -0.1 * y)), Home: goHome, Escape: () => keep(null), ...keys });
}

function listenToTurningHead() {
  showHead();
  at("home").addEventListener("click", goHome);
  at("spin").addEventListener("click", () => {
    state.spinning = !state.spinning;
    at("spin").setAttribute("aria-pressed", String(state.spinning));
    spin();
  });
}
