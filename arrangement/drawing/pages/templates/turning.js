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

/** @type {(view: SVGSVGElement, keys: object, found?: (view: Element, event: PointerEvent) => any) => void} */
function listenToTurns(view, keys, found = underPointer) {
  let held = null;
  view.addEventListener("pointerdown", (event) => {
    if (!event.isPrimary || event.button) return;
    held = { x: event.clientX, y: event.clientY, moved: 0 };
    view.setPointerCapture(event.pointerId);
    view.classList.add("held");
  });
  view.addEventListener("pointermove", (event) => {
    if (!held) {
      const under = found(view, event);
      if (!same(under, state.under)) { state.under = under; refresh(); }
      return;
    }
    const [dx, dy] = [event.clientX - held.x, event.clientY - held.y];
    held.moved += Math.hypot(dx, dy);
    if (held.moved < 4) return;
    const scale = 1 / (RADIUS * view.getScreenCTM().a);
    state.under = null;
    rotate(dx * scale, dy * scale);
    Object.assign(held, { x: event.clientX, y: event.clientY });
  });
  const release = (event) => {
    if (held && held.moved < 4 && event.type === "pointerup") keep(found(view, event));
    held = null;
    view.classList.remove("held");
  };
  view.addEventListener("pointerup", release);
  view.addEventListener("pointercancel", release);
  view.addEventListener("pointerleave", () => { state.under = null; refresh(); });
  onKeys(view, {
    ArrowLeft: () => rotate(-0.1, 0), ArrowRight: () => rotate(0.1, 0),
    ArrowUp: () => rotate(0, -0.1), ArrowDown: () => rotate(0, 0.1),
    Home: goHome, Escape: () => keep(null), ...keys,
  });
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
