// The plane of forces at the torque of the load; `plane.js` draws it.
function paintMap() {
  const view = at("plane");
  paintPlane();
  const tiny = 1e-9 / (scale() * scale());
  const solid = state.slices.filter((part) => part.area > tiny);
  view.querySelectorAll(".piece").forEach((element, k) => { element.dataset.states = String(solid[k].piece.states); });
  paintDifference(view, tiny);
  const stale = state.mapped !== mapKey();
  view.classList.toggle("stale", stale);
  const point = [...shownForce(), state.torque, state.factor];
  const hits = stale ? [] : piecesAt(state.pieces, point);
  const kept = { found: state.found, choice: state.choice };
  const own = state.shownPiece();
  const first = Math.max(0, hits.findIndex((piece) => own && String(piece.states) === String(own.states)));
  Object.assign(state, { found: stale && kept.found?.stable ? [null] : hits, choice: first });
  paintHere();
  Object.assign(state, kept);
  at("plane-title").textContent = `Forces that are resisted at torque ${shortText(state.torque)}`;
  at("plane-caption").textContent = stale ? "Being computed …" : state.other ? comparedWords()
    : "Each polygon: one choice of states, exact. Darker: more contacts stick; hatched: some let go. Drag: changes the force.";
}

// Where another method says something else: red, if it accepts what is not resisted, blue, if it refuses
// what is. Its border is a broken line.
function paintDifference(view, tiny) {
  if (!state.other) return;
  const box = seen();
  const parts = (list) => list.map((piece) => slice(piece, state.torque, state.factor, box)).filter((corners) => corners.length > 2 && areaOf(corners) > tiny);
  const sides = { more: [parts(state.others), parts(state.pieces)], fewer: [parts(state.pieces), parts(state.others)] };
  const layer = draw("g", { class: "difference" }, view);
  const defs = draw("defs", {}, layer);
  for (const [name, [white, black]] of Object.entries(sides)) {
    const pattern = draw("pattern", { id: `only-${name}`, width: 4, height: 4, patternUnits: "userSpaceOnUse", patternTransform: `rotate(${name === "more" ? 45 : -45})` }, defs);
    draw("path", { class: `stripe ${name}`, d: "M0 0V4" }, pattern);
    const frame = { x: -WIDE, y: -HIGH, width: 2 * WIDE, height: 2 * HIGH };
    const mask = draw("mask", { id: `mask-${name}`, maskUnits: "userSpaceOnUse", ...frame }, defs);
    for (const [list, fill] of [[white, "white"], [black, "black"]]) for (const corners of list) draw("path", { d: outline(corners), fill, stroke: fill, "stroke-width": 0.3 }, mask);
    draw("rect", { ...frame, class: "only", fill: `url(#only-${name})`, mask: `url(#mask-${name})` }, layer);
  }
}

// What both say of the load, exactly.
function comparedWords() {
  const say = (yes) => (yes ? "accepts" : "refuses");
  const other = piecesAt(state.others, [...state.wrench, ONE]).length > 0;
  const right = state.fits ? ` The complete model ${say(state.found.stable)} the load, this method ${say(other)} it.` : "";
  return `Compared with ${METHODS[state.other].name}. Red stripes: it accepts what is not resisted; blue: it refuses what is.${right}`;
}

function listenToMethods() {
  const box = at("method");
  for (const [key, { name }] of Object.entries(METHODS)) make("option", { value: key === "complete" ? "" : key }, box, key === "complete" ? "nothing" : name);
  box.addEventListener("change", () => {
    state.other = box.value;
    search();
  });
}

// A window that shows nearly all corners, and the load.
function fitPlane() {
  const most = typical(state.pieces, ([x, y]) => Math.max(x, y));
  const load = Math.max(...floatsOf(state.wrench.slice(0, 2)).map(Math.abs));
  Object.assign(state, { middle: [0, 0], half: Math.max(1.4 * most, 1.5 * load) || 2 });
}

function zoom(factor) {
  state.half = Math.min(1e9, Math.max(1e-6, state.half * factor));
  refresh();
}
