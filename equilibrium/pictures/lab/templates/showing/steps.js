// The two algorithms, step by step.
function stepsOf(kind) {
  if (kind === "planes") {
    const planes = slipPlanes(state.grasp);
    return planes.map((_, k) => ({ kind, count: k + 1, planes, order: planes.map(({ contacts }) => contacts[0]) }));
  }
  return state.states.map((entry, k) => ({ kind, index: k, ...entry }));
}

function tellStep(box, step, all) {
  const kind = at("algorithm").value;
  if (!step) make("p", { class: "hint" }, box, kind === "planes" ? "There is no plane yet: add a contact." : "The states are being found …");
  else if (kind === "planes") tellPlanes(box, step, all);
  else tellState(box, step, all);
}

function stepShown(step) {
  state.motion = step?.kind === "states" ? step.motion : null;
  refresh();
}

function tellPlanes(box, step, all) {
  const { contacts } = step.planes[step.count - 1];
  make("p", {}, box, `Plane ${step.count} of ${all}: T · d = 0 of contact${contacts.length > 1 ? "s" : ""} ${contacts.map((i) => i + 1).join(", ")}`
    + `${contacts.length > 1 ? ", which coincide" : ""}.`);
  const now = countsOf(step.planes.slice(0, step.count));
  paintDual(box, step);
  const row = make("div", { class: "big-number" }, box);
  for (const [value, name] of [[now.regions, "regions = vertices of the dual"], [now.facets, "facets = edges"], [now.rays, "rays = faces"]]) {
    const one = make("div", {}, row);
    make("b", {}, one, String(value));
    make("span", {}, one, name);
  }
  const euler = now.regions - now.facets + now.rays;
  make("p", { class: "hint" }, box, `${now.regions} − ${now.facets} + ${now.rays} = ${euler}: ${euler === 2 ? "Euler's formula, the dual is a polyhedron." : "fewer than three independent planes, so no polyhedron yet."}`);
}

// The dual of the first planes, seen from a fixed side: a vertex has the colour of its region, and
// the edges of the newest plane are bold.
const DUAL_AXES = [[0.83, -0.56, 0], [0.22, 0.33, 0.92], [-0.51, -0.76, 0.4]].map(unit);

function paintDual(box, { count: number, planes }) {
  const contacts = planes.slice(0, number).map((plane) => state.grasp[plane.contacts[0]]);
  const normals = contacts.map((contact) => integers(wrenchesOf(contact).T).row);
  const circles = circlesOf(normals);
  const rayOf = (corner) => pointOf(circles, corner, (ray) => unit(floats(ray)));
  const { places, faces } = zonotopeOf(circles, normals.map((n) => unit(floats(n))), circles.regions, rayOf);
  const view = draw("svg", { id: "dual", class: "view", viewBox: "-110 -110 220 220", role: "img", "aria-label": "The dual polyhedron of these planes." }, box);
  paintDualOf(view, (id) => turned(DUAL_AXES, places.get(id)), {
    faces: faces.map(({ ids }) => ({ ids })),
    edges: circles.arcs.map(({ circle, left, right }) => ({ left, right, tint: circle === number - 1 ? "var(--accent)" : "var(--ink)" })),
    vertices: circles.regions.map(({ id, key }) => ({ id, fill: colourOf([...key].map((s) => (s === "+" ? "slip+" : "slip-"))) })),
  }, false, 6);
}

// One choice of states: its system, its solution, and why it is refused.
function tellState(box, step, all) {
  make("p", {}, box, `State ${step.index + 1} of ${all}: ${step.states.map((s, i) => `${i + 1} ${SIGNS[s]}`).join(", ") || "no contact"}.`);
  const system = systemOf(state.grasp, step.states, loadOf(state.wrench));
  const result = judged(system);
  make("p", { class: result.accepted ? "ok" : "bad" }, box, `${result.accepted ? "✓" : "✗"} ${result.words}`);
  for (const text of result.broken.slice(0, 4)) make("p", { class: "hint" }, box, `• ${text}`);
  const names = ["x", "y", "r"];
  state.grasp.forEach((_, i) => { if (step.states[i] === "stick") names.push(`c_t${i + 1}`); });
  const rows = [...system.balance.map((row, k) => `${rowText(row, names)} = 0   (balance ${["x", "y", "torque"][k]})`),
    ...system.equal.map(({ row, contact }) => `${rowText(row, names)} = 0   (contact ${contact + 1} does not slip)`),
    ...system.atLeast.map(({ row, contact, name }) => `${rowText(row, names)} ≥ 0   (contact ${contact + 1}: ${RULES[name]})`)];
  make("pre", { class: "equations exact", tabindex: 0 }, box, rows.join("\n"));
}

const RULES = { spring: "is let go", normal: "pushes", direction: "slips that way", cone: "in its cone" };
const BROKEN = {
  spring: (i, x) => `contact ${i} would still be in touch: its spring has force ${shortText(minus(x))}`,
  normal: (i, x) => `contact ${i} would pull: normal force ${shortText(x)} is below 0`,
  direction: (i, x) => `contact ${i} would slip the other way (by ${shortText(size(x))}): the motion is not in the state's own cell`,
  cone: (i, x) => `contact ${i}: the friction it needs is outside its cone, by ${shortText(size(x))}`,
};

function judged({ n, balance, equal, atLeast }) {
  const equations = [...balance, ...rowsOf(equal)];
  const lines = new Dictionary(n, equations, []);
  if (!lines.feasible()) return { accepted: false, words: "The equations contradict each other: nothing balances the load here.", broken: [] };
  if (!lines.single) {
    const accepted = new Dictionary(n, equations, rowsOf(atLeast)).feasible();
    return { accepted, words: `The equations have many solutions; ${accepted ? "some obey all conditions: an equilibrium." : "a linear program shows that none obeys all conditions."}`, broken: [] };
  }
  const z = [...lines.point(), ONE];
  const broken = atLeast.map(({ row, name, contact }) => ({ name, contact, value: dotted(row, z) })).filter(({ value }) => value.n < 0n)
    .map(({ name, contact, value }) => BROKEN[name](contact + 1, value));
  return { accepted: !broken.length, words: `d = ${vectorText(z.slice(0, 3))}: ${broken.length ? "rejected." : "all conditions hold, an equilibrium."}`, broken };
}

const rowText = (row, names) => sumText(row.map((x, k) => [textOf(x), names[k] ? ` ${names[k]}` : ""]), (text) => shortText(readNumber(text)));

// The distinct central planes T . d = 0 with the contacts of each, in order of appearance.
function slipPlanes(grasp) {
  const found = Map.groupBy(grasp.keys(), (i) => unoriented(integers(wrenchesOf(grasp[i]).T).row).join());
  return [...found].map(([key, contacts]) => ({ row: key.split(",").map(BigInt), contacts }));
}

// Counts of the arrangement of central planes: regions, their common facets, rays.
function countsOf(planes) {
  const { regions, arcs, crossings } = circlesOf(rowsOf(planes));
  return { regions: regions.length, facets: arcs.length, rays: 2 * crossings.length };
}
