// What is chosen by hand: regions, planes, colours.
function bringToFront() {
  const chosen = state.under ?? state.kept;
  if (!chosen) return;
  const ahead = unit(towards(chosen));
  const up = Math.abs(dot(ahead, state.axes[1])) < 0.95 ? state.axes[1] : state.axes[0];
  state.axes = axesFor(ahead, up);
  refresh();
}

function towards({ kind, id }) {
  if (kind === "point") return data.points[model.points[id].piece].unit;
  if (kind === "arc") return directionOf(data.arcs, model.arcs[id].pieces);
  return directionOf(data.regions, model.regions[id].pieces);
}

function goHome() {
  state.axes = state.even ? data.even.axes : data.axes;
  refresh();
}

// What is kept stays kept when planes come and go: the region is found again by its inner point.
function switchPlanes(change) {
  const piece = state.kept?.kind === "region" ? model.regions[state.kept.id].pieces[0] : null;
  change();
  document.querySelectorAll("#planes input").forEach((/** @type {HTMLInputElement} */ box, k) => {
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

const through = (by) => () => step("region", model.regions.length, by);
const keys = { n: through(1), p: through(-1), f: bringToFront };
listenToTurns(at("sphere"), keys, (view, event) => pick(model, state.axes, ...place(view, event)));
listenToTurns(at("dual"), keys);
listenToTurningHead();
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
at("front").addEventListener("click", bringToFront);
at("clear").addEventListener("click", () => keep(null));
at("all").addEventListener("click", () => switchPlanes(() => state.on.fill(true)));
at("none").addEventListener("click", () => switchPlanes(() => state.on.fill(false)));
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
