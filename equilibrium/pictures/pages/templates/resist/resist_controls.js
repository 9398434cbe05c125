// Pointer, touch, keys and input fields.
function zoom(factor, about = state.middle) {
  const half = Math.min(1e9, Math.max(1e-6, state.half * factor)) * 1;
  const share = half / state.half;
  state.middle = state.middle.map((m, k) => about[k] + (m - about[k]) * share);
  state.half = half;
  refresh();
}

function pan(dx, dy) {
  state.middle = [state.middle[0] - dx, state.middle[1] - dy];
  refresh();
}

function keep(force) {
  state.kept = force;
  state.under = null;
  follow();
}

function move(dx, dy) {
  const step = forceStep();
  const [x, y] = state.kept ?? [ZERO, ZERO];
  keep([plus(x, times(step, ratio(BigInt(dx)))), plus(y, times(step, ratio(BigInt(dy))))]);
}

function nextStates() {
  if (!state.found.length) return;
  state.wanted = codeOf(state.found[(state.choice + 1) % state.found.length].states);
  follow();
}

function goHome() {
  Object.assign(state, { middle: [0, 0], half: state.home });
  refresh();
}

function listen() {
  const view = at("plane");
  const held = new Map();
  let moved = 0;
  view.addEventListener("pointerdown", (event) => {
    if (event.button) return;
    if (!held.size) moved = 0;
    held.set(event.pointerId, [event.clientX, event.clientY]);
    view.setPointerCapture(event.pointerId);
  });
  view.addEventListener("pointermove", (event) => {
    const before = held.get(event.pointerId);
    if (!before) {
      state.under = worldAt(event).map(rounded);
      follow();
      return;
    }
    const now = [event.clientX, event.clientY];
    const [dx, dy] = [now[0] - before[0], now[1] - before[1]];
    moved += Math.hypot(dx, dy);
    if (moved < 4) return;
    view.classList.add("held");
    state.under = null;
    const unit = 1 / (view.getScreenCTM().a * scale());
    const others = [...held].filter(([id]) => id !== event.pointerId);
    if (others.length) {
      const [, other] = others[0];
      const spread = (p) => Math.max(10, Math.hypot(p[0] - other[0], p[1] - other[1]));
      zoom(spread(before) / spread(now));
    }
    pan((dx * unit) / (1 + others.length), (-dy * unit) / (1 + others.length));
    held.set(event.pointerId, now);
  });
  const release = (event) => {
    if (held.delete(event.pointerId) && moved < 4 && event.type === "pointerup") keep(worldAt(event).map(rounded));
    view.classList.remove("held");
  };
  view.addEventListener("pointerup", release);
  view.addEventListener("pointercancel", release);
  view.addEventListener("pointerleave", () => { state.under = null; follow(); });
  view.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom(Math.exp(Math.sign(event.deltaY) * 0.18), worldAt(event));
  }, { passive: false });
  view.addEventListener("keydown", (event) => {
    const keys = {
      ArrowLeft: () => move(-1, 0), ArrowRight: () => move(1, 0), ArrowUp: () => move(0, 1),
      ArrowDown: () => move(0, -1), "+": () => zoom(0.8), "=": () => zoom(0.8), "-": () => zoom(1.25),
      s: nextStates, Home: goHome, Escape: () => keep(null),
    };
    const action = event.ctrlKey || event.metaKey || event.altKey ? null : keys[event.key];
    if (action) { event.preventDefault(); action(); }
  });
}

function slider(id, reach, low, accept) {
  const element = at(id);
  Object.assign(element, { min: low, max: reach, step: reach / 40 });
  element.addEventListener("input", () => accept(readNumber(Number(element.value).toFixed(6))));
}

function begin() {
  at("title").textContent = data.title;
  at("summary").textContent = data.summary;
  at("grasp-caption").textContent = data.stated ? "the object and its contacts"
    : data.outline ? "dashed: an outline that fits the contacts, only indicative" : "the contacts";
  const setTorque = (value) => { state.torque = value; refresh(); return ""; };
  const setFactor = (value) => {
    if (value.n < 0n) return "preload: it must be at least 0.";
    state.factor = value;
    refresh();
    return "";
  };
  ["force-x", "force-y"].forEach((id, k) => field(null, id, `force f_${"xy"[k]}`, (value) => {
    keep((state.kept ?? [ZERO, ZERO]).with(k, value));
    return "";
  }));
  field(null, "torque", "torque τ", setTorque);
  field(null, "preload", "preload", setFactor);
  slider("torque-slider", 1, -1, setTorque);
  slider("preload-slider", data.preload_reach, 0, setFactor);
  at("preload-kind-row").hidden = !sets.has("own");
  const nameIt = () => { at("preload-name").textContent = state.kind === "own" ? "factor" : "preload"; };
  at("preload-kind").value = state.kind;
  at("preload-kind").addEventListener("change", (event) => { state.kind = event.target.value; nameIt(); refresh(); });
  nameIt();
  themeButton(at("theme"));
  at("print").addEventListener("click", () => window.print());
  at("home").addEventListener("click", goHome);
  listen();
  at("verdict").setAttribute("aria-busy", "true");
  inSlices(allPieces(), () => {
    at("verdict").removeAttribute("aria-busy");
    firstView();
    legend();
    goHome();
  }, { first: 80 });
  new ResizeObserver(fit).observe(at("plane"));
  fit();
}

// How much of the plane is shown at first, and how far the torque can be moved.
function firstView() {
  const own = pieces();
  const reach = (sizeOf, load, room, least) => room * Math.max(typical(own, sizeOf) * near(state.factor), ...load.map((x) => Math.abs(near(x)))) || least;
  state.home = reach(([x, y]) => Math.max(x, y), state.kept ?? [], 1.4, 2);
  const far = reach(([,, z]) => z, [state.torque], 1.2, 1);
  Object.assign(at("torque-slider"), { min: -far, max: far, step: far / 40 });
}

begin();
