// The plane of forces at the torque of the load; `plane.js` draws it.
function paintMap() {
  const view = at("plane");
  const stale = state.mapped !== mapKey();
  const hits = stale ? [] : piecesAt(state.pieces, [...state.wrench, ONE]);
  const own = String(state.shownPiece()?.states);
  const piece = hits.find(({ states }) => String(states) === own) ?? hits[0];
  paintPlane(view);
  if (state.other) paintDifference(view);
  paintLoadHere(view, stale ? state.found?.stable : hits.length > 0, piece);
  view.classList.toggle("stale", stale);
  at("plane-title").textContent = `Forces that are resisted at torque ${shortText(state.wrench[2])}`;
  at("plane-caption").textContent = stale ? "Being computed …" : state.other ? comparedWords()
    : "Each polygon: one choice of states. Darker: more contacts stick; hatched: some detached. Drag: changes the force.";
  at("conditions-box").hidden = !piece;
  if (piece) typeset(at("conditions"), [`states: ${piece.states.join(", ")}`, ...conditions(piece)].join("\n"));
}

// The exact conditions of a piece on the wrench.
function conditions({ atLeast, equal }) {
  const words = ({ exact }) => sumText(exact.map((x, k) => [textOf(x), [" f_x", " f_y", " τ", ""][k]]), String);
  return [...atLeast.map((row) => `${words(row)} ≥ 0`), ...equal.map((row) => `${words(row)} = 0`)];
}

// Where another method says something else: red, if it accepts what is not resisted, blue, if it refuses
// what is. Its boundary is a broken line.
function paintDifference(view) {
  const [others, own] = [state.others, state.pieces].map((list) => partsSeen(list).solid.map(({ corners }) => corners));
  const sides = { more: [others, own], fewer: [own, others] };
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

// What both predict for the load, exactly.
function comparedWords() {
  const predicted = (yes) => (yes ? "resisted" : "not resisted");
  const other = piecesAt(state.others, [...state.wrench, ONE]).length > 0;
  const right = state.fits ? ` In the full model the load is ${predicted(state.found.stable)}; this method predicts ${predicted(other)}.` : "";
  return `Compared with ${METHODS[state.other].name}. Red stripes: resisted by this method only; blue stripes: resisted in the full model only.${right}`;
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
  const far = Math.ceil(Math.max(1.2 * typical(state.pieces, ([, , z]) => z), 1.5 * Math.abs(near(state.wrench[2])))) || 4;
  Object.assign(at("s-t"), { min: -far, max: far });
}
