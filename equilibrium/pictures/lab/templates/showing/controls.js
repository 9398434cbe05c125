// Pointer, touch and keys on the pictures.
const steps = () => Number(at("grid").value);
// Numbers, each some steps of the grid further.
const stepped = (row, way) => row.map((x, k) => plus(x, ratio(BigInt(way[k]), BigInt(steps()))));

function dragGrasp() {
  const view = at("grasp");
  onDrag(view, {
    hold(event) {
      const element = event.target.closest("[data-grip]");
      if (!element) return null;
      event.preventDefault();
      hold();
      const name = element.dataset.grip;
      const [kind, i] = name.split("-");
      if (i !== undefined) state.chosen = Number(i);
      element.focus();
      return { name, kind, matrix: matrixOf(view) };
    },
    drag: (held, event) => edit(() => dragTo(held, place(view, event, held.matrix).map((c) => c / UNIT))),
    end({ name }) {
      state.focus = name;
      release();
      refresh();
    },
  });
  view.addEventListener("click", (event) => {
    if (event.target.closest("[data-grip]")) return;
    const p = place(view, event).map((c, k) => (c / UNIT) * data.size + data.centre[k]);
    chooseMotion(rotationAbout(p, state.turn.n < 0n ? -1 : 1));
  });
  // A finger on a grip moves it; elsewhere it scrolls the page.
  view.addEventListener("touchstart", (event) => { if (event.target.closest("[data-grip]")) event.preventDefault(); }, { passive: false });
  onKeys(view, {}, gripKey);
}

// Moves what is held to a place on paper, snapped to exact numbers.
function dragTo({ kind, name }, p) {
  const i = Number(name.split("-")[1]);
  const w = p.map((c, k) => c * data.size + data.centre[k]);
  if (kind === "move") {
    const side = state.outline && at("along").checked ? onOutline(state.outline, w, steps()) : null;
    const { point, normal } = side ?? { point: w.map((c) => onGrid(c, steps())), normal: state.grasp[i].normal };
    state.grasp = state.grasp.with(i, { ...state.grasp[i], point, normal });
  } else if (kind === "turn") {
    const from = data.contacts[i].place;
    state.grasp = state.grasp.with(i, { ...state.grasp[i], normal: nearestDirection(p[0] - from[0], p[1] - from[1]) });
  } else if (kind === "load") {
    const force = p.map((c, k) => onGrid((c - data.origin[k]) / state.scale, steps()));
    state.wrench = [...force, state.wrench[2]];
  } else {
    const angle = Math.atan2(p[1] - data.origin[1], p[0] - data.origin[0]);
    const before = (near(state.wrench[2]) / torqueUnit()) * (Math.PI / 4);
    const turn = angle + 2 * Math.PI * Math.round((before - angle) / (2 * Math.PI));
    const value = (Math.max(-5.5, Math.min(5.5, Math.max(before - 1.5, Math.min(before + 1.5, turn)) / (Math.PI / 4)))) * torqueUnit();
    state.wrench = [...state.wrench.slice(0, 2), onGrid(value, steps())];
  }
}

// What a key does to the grip that has the focus.
function gripKey({ key, target }) {
  const element = target.closest("[data-grip]");
  if (!element) return null;
  const [kind, text] = element.dataset.grip.split("-");
  const i = Number(text);
  const way = { ...ARROWS, "[": [0, 1], "]": [0, -1] }[key];
  const remove = ["Delete", "Backspace"].includes(key) && text !== undefined;
  if (!way && !remove) return null;
  if (text !== undefined) state.chosen = i;
  if (remove) return () => removeContact(i);
  const bracket = key === "[" || key === "]";
  return () => edit(() => {
    if (kind === "turn" || (bracket && kind === "move")) {
      const sense = bracket ? way[1] : way[1] || -way[0];
      state.grasp = state.grasp.with(i, { ...state.grasp[i], normal: nextDirection(state.grasp[i].normal, sense) });
    } else if (kind === "move") {
      state.grasp = state.grasp.with(i, { ...state.grasp[i], point: stepped(state.grasp[i].point, way) });
    } else if (kind === "torque" || bracket) {
      state.wrench = stepped(state.wrench, [0, 0, way[1] || -way[0]]);
    } else {
      state.wrench = stepped(state.wrench, [...way, 0]);
    }
  });
}

function chooseMotion(motion) {
  state.motion = motion;
  refresh();
  if (motion) say(at("motion-words").textContent);
}

function dragPlane() {
  const view = at("plane");
  const move = (event) => edit(() => { state.wrench = [...worldAt(event).map(rounded), state.wrench[2]]; });
  onDrag(view, {
    hold(event) {
      hold();
      move(event);
      return {};
    },
    drag: (_, event) => move(event),
    end: release,
  });
  listenToWheel();
  const by = (x, y) => edit(() => { state.wrench = stepped(state.wrench, [x, y, 0]); });
  onKeys(view, { ...arrowKeys(by), ...ZOOMS, Home: () => { fitPlane(); refresh(); } });
}

// The step that is told is marked like what is under the pointer. The states of a cell or piece under
// the pointer are shown at the contacts.
function markAll() {
  highlight(player.step?.kind === "states" ? [["states", String(player.step.states)]] : []);
  const view = at("grasp");
  view.querySelector(".told-states")?.remove();
  const states = lit.states?.split(",").filter(Boolean) ?? [];
  const told = states.length > 0 && states.length === data.contacts.length;
  view.classList.toggle("told", told);
  if (!told) return;
  const layer = draw("g", { class: "told-states" }, view);
  data.contacts.forEach(({ place: p, normal: n }, i) => paintState(layer, states[i], along(p, n, -0.15), [-n[1], n[0]]));
}
