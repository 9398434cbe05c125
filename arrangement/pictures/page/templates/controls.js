// Pointer, touch, keys and switches.
function rotate(right, up) {
  const [x, y, z] = state.axes;
  const mix = (u, v, a) => [0, 1, 2].map((i) => Math.cos(a) * u[i] + Math.sin(a) * v[i]);
  const ahead = mix(z, x, -right);
  const side = mix(x, z, right);
  settle(side, mix(y, ahead, -up), mix(ahead, y, up));
}

// Round-off in thousands of small turns must not bend the axes.
function settle(x, y, z) {
  const ahead = unit(z);
  const right = unit(cross(y, ahead));
  state.axes = [right, cross(ahead, right), ahead];
  refresh();
}

function bringToFront() {
  const chosen = state.under ?? state.kept;
  if (!chosen) return;
  const target = towards(chosen);
  const up = Math.abs(dot(target, state.axes[1])) < 0.95 ? state.axes[1] : state.axes[0];
  settle(null, unit(cross(target, cross(up, target))), target);
}

function towards({ kind, id }) {
  if (kind === "point") return data.points[model.points[id].piece].unit;
  if (kind === "arc") return directionOf(data.arcs, model.arcs[id].pieces);
  return directionOf(data.regions, model.regions[id].pieces);
}

const same = (one, other) => one?.kind === other?.kind && one?.id === other?.id;

function keep(chosen) {
  state.kept = chosen && !same(chosen, state.kept) ? chosen : null;
  refresh();
}

function step(by) {
  const start = state.kept?.kind === "region" ? state.kept.id : by > 0 ? -1 : 0;
  const n = model.regions.length;
  state.under = null;
  state.kept = { kind: "region", id: (start + by + n) % n };
  refresh();
}

function found(view, event) {
  if (view.id === "sphere") return pick(model, state.axes, ...place(view, event));
  const element = document.elementFromPoint(event.clientX, event.clientY);
  const { kind, id } = element?.dataset ?? {};
  return kind && view.contains(element) ? { kind, id: Number(id) } : null;
}

for (const view of [at("sphere"), at("dual")]) {
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
  view.addEventListener("keydown", (event) => {
    const keys = {
      ArrowLeft: () => rotate(-0.1, 0), ArrowRight: () => rotate(0.1, 0),
      ArrowUp: () => rotate(0, -0.1), ArrowDown: () => rotate(0, 0.1),
      n: () => step(1), p: () => step(-1), f: bringToFront,
      Home: goHome, Escape: () => keep(null),
    };
    const action = event.ctrlKey || event.metaKey || event.altKey ? null : keys[event.key];
    if (action) { event.preventDefault(); action(); }
  });
}

function goHome() {
  state.axes = state.even ? data.even.axes : data.axes;
  refresh();
}

function spin() {
  if (!state.spinning) return;
  rotate(0.006, 0);
  requestAnimationFrame(spin);
}

// What is kept stays kept when planes come and go: the region is found again by its inner point.
function switchPlanes(change) {
  const piece = state.kept?.kind === "region" ? model.regions[state.kept.id].pieces[0] : null;
  change();
  const boxes = document.querySelectorAll("#planes input");
  boxes.forEach((box, k) => {
    box.checked = state.on[k];
    box.parentElement.classList.toggle("off", !state.on[k]);
  });
  state.kept = null;
  rebuild();
  if (piece !== null) keep({ kind: "region", id: model.regions.findIndex((r) => r.pieces.includes(piece)) });
}

function listPlanes() {
  data.planes.forEach((plane, k) => {
    const line = make("li", {}, at("planes"));
    const label = tinted(make("label", {}, line), plane.circle);
    const box = make("input", { type: "checkbox", checked: "" }, label);
    make("b", {}, label, String(k + 1));
    make("span", { class: "exact" }, label, plane.equation);
    const first = data.classes[plane.circle][0];
    if (first !== k) make("span", { class: "also" }, label, `= ${first + 1}`);
    box.addEventListener("change", () => switchPlanes(() => { state.on[k] = box.checked; }));
  });
}

at("title").textContent = data.title;
at("summary").textContent = data.summary;
listPlanes();
at("even").checked = state.even;
if (data.even) at("shape").textContent = data.even.name;
at("even").parentElement.hidden = !data.even;
at("even").addEventListener("change", (event) => {
  state.even = event.target.checked;
  switchPlanes(() => { state.axes = setShape(state.even); });
});
state.axes = setShape(state.even);
at("colour").value = state.colour;
themeButton(at("theme"));
at("print").addEventListener("click", () => window.print());
at("home").addEventListener("click", goHome);
at("front").addEventListener("click", bringToFront);
at("clear").addEventListener("click", () => keep(null));
at("all").addEventListener("click", () => switchPlanes(() => state.on.fill(true)));
at("none").addEventListener("click", () => switchPlanes(() => state.on.fill(false)));
at("spin").addEventListener("click", () => {
  state.spinning = !state.spinning;
  at("spin").setAttribute("aria-pressed", String(state.spinning));
  spin();
});
at("regions").addEventListener("change", (event) => {
  state.kept = null;
  keep(event.target.value === "" ? null : { kind: "region", id: Number(event.target.value) });
  bringToFront();
});
at("colour").addEventListener("change", (event) => { state.colour = event.target.value; rebuild(); });
at("labels").addEventListener("change", refresh);
at("unit").addEventListener("change", () => {
  shown.places = dualPlaces(model, at("unit").checked);
  refresh();
});
at("tinted").addEventListener("change", (event) => {
  document.body.classList.toggle("plain", !event.target.checked);
});
rebuild();
