// The page of an arrangement: circles and dual of the lab, without dragging. They turn together; planes come and go.
const state = {
  dimension: 3, rows: data.planes.map(data.field ? algebraicRow : (row) => row.map(exactNumber)),
  on: data.planes.map(() => true), projective: false, equal: true, colour: "none",
  shape: null, axes: null, under: null, kept: null, spinning: false,
};

function arrangementShown() {
  const numbers = [...state.rows.keys()].filter((k) => state.on[k]);
  return arrangementOf({ dimension: 3, rows: numbers.map((k) => state.rows[k]), numbers });
}

const all = arrangementShown();
const whole = () => all;
const present = { arrangement: all };
const shown = () => present;
const refresh = oncePerFrame(paint);

function paint() {
  const frame = paintGlobe(at("ball"), () => ({ class: "line" }));
  const places = paintDual();
  lit.mark = state.under ?? state.kept;
  highlight([["mark", state.kept]]);
  for (const mark of new Set([state.kept, state.under])) if (mark) light(mark, frame, places);
  describe();
}

// What is marked on the ball, also on its far side, and the vertex of a region.
function light(mark, frame, places) {
  const { circles } = shown().arrangement;
  const [kind, id] = mark.split("-");
  const view = at("ball");
  if (kind === "region") {
    const [far, near] = [-1, 1].map((side) => regionPath(circles.regions[id], frame, side));
    draw("path", { class: "ghost", d: far }, view);
    draw("path", { class: "mark outline", d: near }, view);
    const [cx, cy] = spot(places.get(Number(id))).split(",");
    draw("circle", { class: "mark ring", cx, cy, r: 6 }, at("dual"));
  } else if (kind === "arc") {
    for (const side of [-1, 1]) draw("path", { class: side > 0 ? "mark" : "mark hidden", d: visible(frame[id], side) }, view);
  } else {
    const p = turned(state.axes, pointOf(circles, Number(id), ballPoint));
    const [cx, cy] = spot(p).split(",");
    draw("circle", { class: p[2] >= 0 ? "mark spot" : "mark spot hidden", cx, cy, r: 3.6 }, view);
  }
}

function describe() {
  const found = told(lit.mark);
  at("start").hidden = Boolean(found);
  at("told").classList.toggle("active", Boolean(found));
  at("front").disabled = !found;
  at("clear").disabled = !state.kept;
  at("chosen-title").textContent = found ? found.title : "Nothing chosen";
  facts(at("chosen"), found ? found.facts : []);
  const [kind, id] = (lit.mark ?? "").split("-");
  at("regions").value = kind === "region" ? id : "";
}

// What is under a place of the disk: a crossing, an arc, or a region. In a small region the margins
// of its arcs are small too, so that it can always be reached.
function pick(view, event) {
  const [x, y] = place(view, event).map((c) => c / RADIUS);
  if (Math.hypot(x, y) > 1) return null;
  const p = directionAt(state.axes, x, y);
  const { arrangement } = shown();
  const { circles } = arrangement;
  const heights = circles.normals.map((n) => dot(ballNormal(n), p));
  const key = heights.map((h) => (h >= 0 ? "+" : "-")).join("");
  const region = circles.regions.find((one) => one.key === key);
  if (!region) return null;
  const { room } = middleOf(arrangement, region);
  const corner = region.corners.find((k) => {
    const ray = pointOf(circles, k, ballPoint);
    return dot(ray, p) > 0 && Math.hypot(...cross(ray, p)) < Math.min(0.045, 0.8 * room);
  });
  if (corner !== undefined) return `point-${corner}`;
  let [best, least] = [`region-${region.id}`, Math.min(0.022, 0.4 * room)];
  for (const dart of region.darts) {
    const distance = Math.abs(heights[circles.arcs[dart >> 1].circle]);
    if (distance < least) [best, least] = [`arc-${dart >> 1}`, distance];
  }
  return best;
}

function bringToFront() {
  const mark = state.under ?? state.kept;
  if (!mark) return;
  const { arrangement } = shown();
  const [kind, id] = mark.split("-");
  const curve = kind === "arc" ? curvesOf(arrangement)[id] : null;
  const ahead = kind === "region" ? middleOf(arrangement, arrangement.circles.regions[id]).towards
    : curve ? curve[curve.length >> 1] : pointOf(arrangement.circles, Number(id), ballPoint);
  state.axes = axesFor(ahead, Math.abs(dot(ahead, state.axes[1])) < 0.95 ? state.axes[1] : state.axes[0]);
  refresh();
}

const UNCHANGED = { points: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], normals: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], axes: data.axes };
function goHome() {
  state.axes = state.shape.axes;
  refresh();
}

// A linear change of coordinates makes the regions more alike. Signs stay.
function chooseShape(even) {
  at("even").checked = even;
  state.shape = even ? data.even : UNCHANGED;
  goHome();
}

// A region that is kept stays kept when planes come and go: one with the same signs.
function switchPlanes(change) {
  const signs = (arrangement, { key }) => signsText(arrangement, keySigns(key));
  const [kind, id] = (state.kept ?? "").split("-");
  const before = kind === "region" ? [...signs(present.arrangement, present.arrangement.circles.regions[id])] : null;
  change();
  document.querySelectorAll("#planes input").forEach((/** @type {HTMLInputElement} */ box, k) => {
    box.checked = state.on[k];
    box.parentElement.classList.toggle("off", !state.on[k]);
  });
  present.arrangement = arrangementShown();
  const { regions } = present.arrangement.circles;
  const still = before && regions.find((region) => [...signs(present.arrangement, region)].every((s, k) => s === before[k] || [s, before[k]].includes("·")));
  Object.assign(state, { under: null, kept: still ? `region-${still.id}` : null });
  showPanels();
  refresh();
}

function showPanels() {
  const { arrangement } = shown();
  const { regions, arcs, crossings, rank } = arrangement.circles;
  const [r, a, p] = [regions.length, arcs.length, 2 * crossings.length];
  at("ball-counts").textContent = `${count(r, "region", "regions")}, ${count(a, "arc", "arcs")}, ${count(p, "crossing", "crossings")}`;
  at("dual-name").textContent = `dual ${["point", "segment", "polygon", "polyhedron"][rank]}`;
  at("dual-counts").textContent =
    `${count(r, "vertex", "vertices")}, ${count(a, "edge", "edges")}, ${count(p, rank === 2 ? "side" : "face", rank === 2 ? "sides" : "faces")}`;
  const list = at("regions");
  list.replaceChildren(make("option", { value: "" }, null, "choose"));
  regions.map(({ id, key }) => ({ id, signs: signsText(arrangement, keySigns(key)) })).sort((one, other) => (one.signs < other.signs ? -1 : 1))
    .forEach(({ signs, id }) => make("option", { value: id }, list, signs || "(no plane)"));
  showLegend();
}

function listPlanes() {
  state.rows.forEach((row, k) => {
    const circle = all.members.findIndex((list) => list.includes(k));
    const label = make("label", {}, make("li", {}, at("planes")));
    label.style.setProperty("--tint", lineColour(all, circle));
    const box = make("input", { type: "checkbox", checked: "" }, label);
    make("b", {}, label, planeName(k));
    make("span", { class: "exact" }, label, equationText(row, (text) => text));
    const [first] = all.members[circle];
    if (first !== k) make("span", { class: "also" }, label, `= ${planeName(first)}`);
    box.addEventListener("change", () => switchPlanes(() => { state.on[k] = box.checked; }));
  });
}

const through = (by) => () => step("region", shown().arrangement.circles.regions.length, by);
const keys = { n: through(1), p: through(-1), f: bringToFront };
listenToTurns(at("ball"), keys, pick);
listenToTurns(at("dual"), keys);
listenToTurningHead();
listenToColours();
listPlanes();
if (data.even) at("shape").textContent = data.even.name;
at("even").parentElement.hidden = !data.even;
at("even").addEventListener("change", () => chooseShape(at("even").checked));
at("front").addEventListener("click", bringToFront);
at("clear").addEventListener("click", () => keep(null));
at("all").addEventListener("click", () => switchPlanes(() => state.on.fill(true)));
at("none").addEventListener("click", () => switchPlanes(() => state.on.fill(false)));
at("regions").addEventListener("change", () => {
  state.kept = at("regions").value ? `region-${at("regions").value}` : null;
  refresh();
  bringToFront();
});
at("equal").addEventListener("change", () => { state.equal = at("equal").checked; refresh(); });
at("tinted").addEventListener("change", () => document.body.classList.toggle("plain", !at("tinted").checked));
chooseColour(data.colour ?? suitedColour(all));
chooseShape(Boolean(data.even?.at_first));
showPanels();
paint();
