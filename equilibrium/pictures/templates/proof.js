// The parts of a proof on two maps, and the virtual motion and inequality of the one shown.
const state = { chosen: data.first, under: null };
const shapes = data.parts.map(() => []);
const SCALE = 100;
const shown = () => state.under ?? state.chosen;
const motionOf = (part) => data.motions[data.parts[part].motion];
const nameOf = (part) => `part ${part + 1}: virtual motion ${data.parts[part].motion + 1}`;

function choose(part) {
  Object.assign(state, { chosen: part, under: null });
  refresh();
}

function paintMap(which) {
  const view = at(`map-${which}`);
  const { title, shapes: found } = data.maps[which];
  view.setAttribute("aria-label", `${title}, in the plane of the object`);
  at(`map-${which}-caption`).textContent = title;
  const below = draw("g", {}, view);
  const paths = found.map(({ part, corners, label }) => {
    const d = `M${corners.map(([x, y]) => `${fixed(SCALE * x)},${fixed(-SCALE * y)}`).join("L")}Z`;
    const colour = data.colours[data.parts[part].motion];
    const line = corners.length < 3;
    const path = draw("path", { d, class: line ? "part line" : "part", [line ? "stroke" : "fill"]: colour,
      role: "button", tabindex: -1, "data-part": part, "aria-label": nameOf(part) }, below);
    shapes[part].push(path);
    path.addEventListener("focus", () => choose(part));
    path.addEventListener("click", () => choose(part));
    path.addEventListener("pointerenter", (event) => {
      if (event.pointerType !== "touch") { state.under = part; refresh(); }
    });
    if (label) {
      const [x, y] = label.map((v) => SCALE * v);
      draw("text", { class: "number", x: fixed(x), y: fixed(-y) }, view, String(data.parts[part].motion + 1));
    }
    return path;
  });
  view.addEventListener("pointerleave", () => { state.under = null; refresh(); });
  onKeys(view, arrowKeys((x, y) => paths[(paths.indexOf(document.activeElement) + x - y + paths.length) % paths.length].focus()));
  const ghost = draw("g", { class: "ghost", transform: `scale(${SCALE / data.half / UNIT})` });
  below.after(ghost);
  if (data.outline) paintBody(ghost);
  for (const contact of data.contacts) paintContact(ghost, contact);
  draw("rect", { class: "frame", x: -SCALE, y: -SCALE, width: 2 * SCALE, height: 2 * SCALE }, view);
  draw("g", { class: "marks" }, view);
}

// The regions of the part shown; Tab leads to the one that is chosen, or to the first of a map.
function mark() {
  for (const which of [0, 1]) {
    const view = at(`map-${which}`);
    const marks = view.querySelector(".marks");
    marks.replaceChildren();
    const paths = [...view.querySelectorAll(".part")];
    const stop = paths.find((path) => Number(path.dataset.part) === state.chosen) ?? paths[0];
    for (const path of paths) {
      path.setAttribute("tabindex", path === stop ? 0 : -1);
      path.classList.toggle("held", Number(path.dataset.part) === shown());
      if (Number(path.dataset.part) === shown()) draw("path", { class: "rim", d: path.getAttribute("d") }, marks);
    }
  }
}

function paintGrasp() {
  const view = at("grasp");
  const { turn, centre, shifts } = motionOf(shown());
  view.replaceChildren();
  if (data.outline) paintBody(view);
  for (const contact of data.contacts) paintContact(view, contact);
  arrow(view, data.origin, along(data.origin, data.load.force, 0.7), "load", 1.4);
  paintOrigin(view);
  if (data.load.turn) paintTwist(view, data.origin, data.load.turn);
  const motion = draw("g", { class: "shift" }, view);
  data.contacts.forEach(({ place: p }, i) => arrow(motion, p, along(p, shifts[i], 0.45), "load", 1.1));
  const far = centre ? Math.max(...centre.map(Math.abs)) * UNIT : Infinity;
  if (far < 116 - 0.3 * UNIT) paintTwist(motion, centre, turn);
  if (far < 114) {
    draw("circle", { class: "centre", cx: fixed(UNIT * centre[0]), cy: fixed(-UNIT * centre[1]), r: 3 }, motion);
  }
  paintNames(view);
}

function describe() {
  const part = data.parts[shown()];
  const motion = motionOf(shown());
  const [load, least, total] = part.works;
  at("part").value = shown();
  at("said").textContent = `Part ${shown() + 1} of ${data.parts.length}. The virtual motion λ = ${motion.text} `
    + `${motion.words}. On it ${data.stuck ? "the load and adhesion do" : "the load does"} work ${load}, the contacts at least ${least}: `
    + `together at least ${total}, above 0. Forces in balance would do no work, so there are none.`;
  ["load", "contacts", "total"].forEach((id, k) => {
    at(id).textContent = [`${data.stuck ? "load and adhesion" : "load"} ${load}`, `+ contacts ≥ ${least}`, `= at least ${total} > 0`][k];
    at(id).title = part.exact[k];
  });
  facts(at("facts"), [
    ["virtual motion λ = (x, y, r)", motion.exact, true],
    ...(part.states.length ? [["states of this part", part.states.join(", ")]] : []),
    ["its motions (d₀, x, y, r): sums of multiples ≥ 0 of", part.cone.join("\n"), true],
  ]);
  at("works").replaceChildren();
  part.factors.forEach((factor, i) => {
    const row = make("tr", {}, at("works"));
    make("td", {}, row, String(i + 1));
    const style = factor === null ? "none" : /^≈?−/.test(factor) ? "against" : "";
    make("td", { class: style }, row, factor === null ? "no force in this part" : `at least ${factor} c`);
  });
}

const refresh = oncePerFrame(() => { mark(); paintGrasp(); describe(); });

function begin() {
  showHead();
  [0, 1].forEach(paintMap);
  data.parts.forEach((part, i) => {
    const seen = shapes[i].length ? "" : " (not on the maps)";
    make("option", { value: i }, at("part"), `${nameOf(i)}${seen}`.replace("part ", ""));
  });
  for (const line of data.question) make("li", {}, at("question"), line);
  at("part").addEventListener("change", (event) => choose(Number(event.target.value)));
  for (const [id, step] of /** @type {[string, number][]} */ ([["back", -1], ["next", 1]])) {
    at(id).addEventListener("click", () => choose((state.chosen + step + data.parts.length) % data.parts.length));
  }
  refresh();
}

begin();
