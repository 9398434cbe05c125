// Pictures that turn: by drag, by keys, by themselves. What is under the pointer lights up, a click keeps it.
// A page defines state, with axes, under, kept and spinning, refresh() and goHome().
const same = (one, other) => one?.kind === other?.kind && one?.id === other?.id;

function rotate(right, up) {
  state.axes = turnedAxes(state.axes, right, up);
  refresh();
}

function keep(chosen) {
  state.kept = chosen && !same(chosen, state.kept) ? chosen : null;
  refresh();
}

// The next or the previous one of all things of a kind.
function step(kind, number, by) {
  if (!number) return;
  const start = state.kept?.kind === kind ? state.kept.id : by > 0 ? -1 : 0;
  Object.assign(state, { under: null, kept: { kind, id: (start + by + number) % number } });
  refresh();
}

function spin() {
  if (!state.spinning) return;
  rotate(0.006, 0);
  requestAnimationFrame(spin);
}

function underPointer(view, event) {
  const element = /** @type {HTMLElement} */ (document.elementFromPoint(event.clientX, event.clientY));
  const { kind, id } = element?.dataset ?? {};
  return kind && view.contains(element) ? { kind, id: Number(id) } : null;
}

/** @type {(view: SVGSVGElement, keys: Record<string, () => void>, found?: (view: Element, event: PointerEvent) => any) => void} */
function listenToTurns(view, keys, found = underPointer) {
  onDrag(view, {
    drag({ dx, dy }) {
      const scale = 1 / (RADIUS * view.getScreenCTM().a);
      state.under = null;
      rotate(dx * scale, dy * scale);
    },
    click: (event) => keep(found(view, event)),
  });
  const point = (under) => { if (!same(under, state.under)) { state.under = under; refresh(); } };
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
