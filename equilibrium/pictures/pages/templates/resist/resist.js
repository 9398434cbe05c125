// What is chosen, and what the page says about it.
const given = readGrasp(data.grasp);
const state = {
  torque: readNumber(data.torque), factor: readNumber(data.factor), kind: data.kind,
  middle: [0, 0], half: 2, home: 2, kept: data.force && data.force.map(readNumber), under: null,
  found: [], choice: 0, wanted: null, fixed: null, slices: [], overlay: null,
};
// The pieces without preload, with preload 1, and with the preloads of the file.
/** @type {Map<string, any[]>} */
const sets = new Map(data.kinds.map((kind) => [kind, []]));
const refresh = oncePerFrame(() => { paintPlane(); answer(); });
const follow = oncePerFrame(answer);

const pieces = () => sets.get(state.factor.n === 0n ? "none" : state.kind);
const shownForce = () => state.under ?? state.kept;

// The grasp with preloads of a kind times a factor.
const loaded = (kind, factor) => given.map((contact) => ({ ...contact,
  preload: kind === "own" ? times(contact.preload, factor) : kind === "uniform" ? factor : ZERO }));

function* allPieces() {
  for (const kind of sets.keys()) {
    const grasp = loaded(kind, ONE);
    const found = [];
    for (const piece of piecesOf(grasp, statesOf(grasp))) { if (piece) found.push(piece); yield null; }
    sets.set(kind, yield* maximal(found));
  }
}

function wrenchPoint() {
  const force = shownForce();
  return force ? [...force, state.torque, state.factor] : null;
}

// The exact answer for the chosen force, then all that depends on it.
function answer() {
  const point = wrenchPoint();
  state.found = point ? piecesAt(pieces(), point) : [];
  const again = state.found.findIndex((piece) => codeOf(piece.states) === state.wanted);
  state.choice = Math.max(0, again);
  const piece = state.found[state.choice];
  state.fixed = piece ? fixedBy(loaded(state.kind, state.factor), piece.states, point.slice(0, 3)) : null;
  paintHere();
  paintGrasp();
  describe(point);
}

function describe(point) {
  const verdict = at("verdict");
  at("start").hidden = Boolean(point);
  const resisted = state.found.length > 0;
  const busy = verdict.getAttribute("aria-busy") === "true";
  verdict.textContent = busy ? "Being computed …" : !point ? "No force chosen" : resisted ? "Resisted" : "Not resisted";
  verdict.className = busy || !point ? "" : resisted ? "yes" : "no";
  const piece = state.found[state.choice];
  at("choices").replaceChildren();
  if (state.found.length > 1) {
    state.found.forEach((other, k) => {
      const pressed = String(k === state.choice);
      const button = make("button", { "aria-pressed": pressed, title: other.states.join(", ") }, at("choices"), codeOf(other.states));
      button.addEventListener("click", () => { state.wanted = codeOf(other.states); follow(); });
    });
  }
  const list = point ? [["force (f_x, f_y)", tuple(point.slice(0, 2).map(decimal)), true]] : [];
  if (piece) {
    list.push(["states", piece.states.join(", ")]);
    if (state.found.length > 1) list.push(["", `${state.found.length} choices of states resist it`]);
    list.push(["motion (x, y, r)", state.fixed.motion.every(Boolean) ? tuple(state.fixed.motion.map(textOf)) : "not fixed by the states", state.fixed.motion.every(Boolean)]);
    if (state.kept && !state.under) list.push(["piece", conditions(piece), true]);
  }
  facts(at("facts"), list);
  listForces(piece);
  writeFields();
  at("plane-caption").textContent =
    `forces at torque ${decimal(state.torque)}, ${preloadWords()}`;
}

// The exact conditions of a piece, in the wrench (f_x, f_y, τ) and the preload factor p.
function conditions(piece) {
  const words = ({ exact }) => exact.map(textOf).map((text, i) => {
    const size = text.replace("-", "");
    if (size === "0") return "";
    return `${text.startsWith("-") ? "- " : "+ "}${size === "1" ? "" : `${size} `}${["f_x", "f_y", "τ", "p"][i]}`;
  }).filter(Boolean).join(" ").replace(/^\+ /, "").replace(/^- /, "-");
  return [...piece.atLeast.map((row) => `${words(row)} ≥ 0`),
    ...piece.equal.map((row) => `${words(row)} = 0`)].join("\n") || "all wrenches";
}

function preloadWords() {
  if (state.factor.n === 0n) return "no preload";
  return state.kind === "own" ? `preloads of the file times ${decimal(state.factor)}` : `preload ${decimal(state.factor)}`;
}

function listForces(piece) {
  const table = at("forces");
  table.replaceChildren();
  at("forces-hint").textContent = !piece ? "Choose a force that is resisted."
    : state.fixed.forces.flat().every(Boolean) ? "Normal and tangential component; exact."
      : "Normal and tangential component; exact. Where dots stand, these states allow more than one force.";
  if (!piece) return;
  const head = make("tr", {}, table);
  for (const text of ["", "state", "normal", "tangential"]) make("th", { scope: "col" }, head, text);
  piece.states.forEach((what, i) => {
    const row = make("tr", {}, table);
    make("td", {}, row, String(i + 1));
    make("td", {}, row, `${CODES[what]} ${what}`);
    for (const k of [0, 1]) {
      const force = state.fixed.forces[i][k];
      make("td", { class: "exact" }, row, force ? textOf(force) : "…");
    }
  });
}

function writeFields() {
  const force = shownForce();
  const values = { "force-x": force?.[0], "force-y": force?.[1], torque: state.torque, preload: state.factor };
  for (const [id, value] of Object.entries(values)) writeText(id, value ? decimal(value) : "");
  at("torque-slider").value = near(state.torque);
  at("preload-slider").value = near(state.factor);
}

function legend() {
  const list = at("legend");
  list.replaceChildren();
  const all = [...sets.values()].flat();
  const key = (text, paint) => {
    const line = make("li", {}, list);
    paint(draw("svg", { viewBox: "-5 -5 10 10", "aria-hidden": "true" }, line));
    line.append(text);
  };
  for (const number of [...new Set(all.map(stuck))].sort()) {
    key(`${number}${number === 3 && data.contacts.length > 3 ? " or more" : ""} stick`, (box) => draw("rect", { x: -4.5, y: -4.5, width: 9, height: 9, class: `s${number}` }, box));
  }
  if (all.some((piece) => piece.states.includes("detached"))) {
    key("some detached", (box) => draw("path", { d: "M-5 1L1 -5M-5 5L5 -5M-1 5L5 -1", stroke: "var(--ink)", "stroke-width": 0.8 }, box));
  }
  key("resistance ends", (box) => draw("path", { d: "M-5 0H5", class: "rim" }, box));
  const kinds = new Set(all.flatMap((piece) => piece.states));
  for (const what of Object.keys(CODES).filter((name) => kinds.has(name))) {
    const line = make("li", {}, list);
    line.append(`${CODES[what]} ${what}`);
  }
}
