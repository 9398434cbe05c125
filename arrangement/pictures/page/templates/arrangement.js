// The page: one rotation for both drawings, one thing under the pointer, one thing kept.
const state = {
  even: Boolean(data.even?.at_first), axes: null, on: data.planes.map(() => true), colour: null,
  under: null, kept: null, spinning: false,
};
const arcsOf = data.classes.map((_, circle) => data.arcs.flatMap((arc, k) => (arc.circle === circle ? [k] : [])));
let model = modelOf(state.on);
state.colour = data.colour ?? (new Set(model.regions.map((region) => region.arcs.length)).size > 1 ? "sides" : "parity");
// The arcs and dual vertices as they are drawn, for the present axes.
const shown = { styles: [], places: [], frame: [], turned: [] };
const refresh = oncePerFrame(paint);

function rebuild() {
  model = modelOf(state.on);
  shown.places = dualPlaces(model, at("unit").checked);
  shown.styles = model.regions.map(colourOf(model, state.colour));
  state.under = null;
  buildPanels();
  paint();
}

function tint(circle) {
  const fixedTints = ["#1f77b4", "#d1495b", "#2a9d5c", "#b8791a", "#8e5bb5", "#3aa6a6", "#a0522d", "#6c757d"];
  if (data.classes.length <= fixedTints.length) return fixedTints[circle];
  return `hsl(${Math.round(circle * 137.5) % 360} 55% 48%)`;
}

function tinted(element, circle) {
  element.style.setProperty("--tint", tint(circle));
  return element;
}

function buildPanels() {
  const [r, a, p] = [model.regions.length, model.arcs.length, model.points.length];
  at("sphere-counts").textContent =
    `${count(r, "region", "regions")}, ${count(a, "arc", "arcs")}, ${count(p, "crossing", "crossings")}`;
  const names = ["point", "segment", "polygon", "polyhedron"];
  const rank = p > 2 ? 3 : Math.min(2, model.classOn.filter(Boolean).length);
  at("dual-name").textContent = `dual ${names[rank]}`;
  at("dual-counts").textContent =
    `${count(r, "vertex", "vertices")}, ${count(a, "edge", "edges")}, ${count(p, rank === 2 ? "side" : "face", rank === 2 ? "sides" : "faces")}`;
  at("legend").replaceChildren();
  for (const entry of legendOf(model, state.colour)) {
    const line = make("li", {}, at("legend"));
    const box = draw("svg", { viewBox: "0 0 10 10", "aria-hidden": "true" }, line);
    draw("rect", { width: 9, height: 9, x: 0.5, y: 0.5, class: entry.colour }, box);
    line.append(`${entry.text} (${entry.number})`);
  }
  const list = at("regions");
  list.replaceChildren(make("option", { value: "" }, null, "choose"));
  model.regions.map((region, id) => ({ signs: region.signs, id }))
    .sort((one, other) => (one.signs < other.signs ? -1 : 1))
    .forEach(({ signs, id }) => make("option", { value: id }, list, signs || "(no plane)"));
}

function paint() {
  shown.frame = curves.map((curve) => curve.map((p) => turned(state.axes, p)));
  shown.turned = shown.places.map((p) => turned(state.axes, p));
  paintSphere(at("sphere"));
  paintDual(at("dual"));
  const chosen = state.under ?? state.kept;
  for (const item of [state.kept, state.under]) if (item) light(item);
  describe(chosen);
  at("regions").value = chosen?.kind === "region" ? String(chosen.id) : "";
}

function paintSphere(view) {
  const regions = model.regions.map((region, id) =>
    ({ class: `region ${shown.styles[id]}`, d: regionPath(region, shown.frame, 1), "data-kind": "region", "data-id": id }));
  const circles = [...data.classes.keys()].filter((circle) => model.classOn[circle])
    .map((circle) => ({ class: "circle", tint: tint(circle), curves: arcsOf[circle].map((arc) => shown.frame[arc]) }));
  paintBallOf(view, regions, circles);
  for (const entry of limbNumbers(model, state.axes)) {
    const [c, s, x, y] = [Math.cos(entry.shown), Math.sin(entry.shown), Math.cos(entry.angle), Math.sin(entry.angle)];
    draw("path", { class: "lead", d: `M${spot([x, y])}L${spot([1.06 * c, 1.06 * s])}` }, view);
    tinted(draw("text", { class: "number", x: 112 * c, y: -112 * s + 2.6 }, view, entry.text), entry.circle);
  }
  if (at("labels").checked) labelRegions(view);
}

function labelRegions(group) {
  for (const region of model.regions) {
    const room = roomOf(model, region);
    const p = turned(state.axes, region.inside);
    if (p[2] > 0.15 && 1.9 * region.signs.length < room * p[2] * RADIUS) {
      draw("text", { class: "tag", x: fixed(RADIUS * p[0]), y: fixed(-RADIUS * p[1]) }, group, minusSign(region.signs));
    }
  }
}

function paintDual(view) {
  const inFront = paintDualOf(view, (id) => shown.turned[id], {
    faces: model.points.map(({ cycle }, id) => ({ ids: cycle, "data-kind": "point", "data-id": id })),
    edges: model.arcs.map(({ left, right, circle }, id) => ({ left, right, tint: tint(circle), "data-kind": "arc", "data-id": id })),
    vertices: model.regions.map((_, id) => ({ id, style: shown.styles[id], "data-kind": "region", "data-id": id })),
  }, false, Math.max(1.6, Math.min(4, 24 / Math.sqrt(model.regions.length))));
  if (at("labels").checked) labelVertices(view, shown.turned, inFront);
}

function labelVertices(group, places, inFront) {
  const taken = [];
  const order = places.map((_, id) => id).filter(inFront).sort((a, b) => places[b][2] - places[a][2]);
  for (const id of order) {
    const [x, y] = places[id];
    const half = 1.9 * model.regions[id].signs.length;
    const n = Math.hypot(x, y) || 1;
    const middle = [RADIUS * x + (x / n) * (half + 3), RADIUS * y + (y / n) * 7];
    const clash = taken.some(([u, v, w]) => Math.abs(u - middle[0]) < w + half && Math.abs(v - middle[1]) < 6.5);
    if (clash || Math.abs(middle[0]) + half > 124) continue;
    taken.push([...middle, half]);
    draw("text", { class: "tag", x: fixed(middle[0]), y: fixed(-middle[1]) }, group, minusSign(model.regions[id].signs));
  }
}

function light({ kind, id }) {
  const [ball, dual] = [at("sphere"), at("dual")];
  for (const element of document.querySelectorAll(`[data-kind="${kind}"][data-id="${id}"]`)) element.classList.add("lit");
  if (kind === "region") {
    const [far, near] = [-1, 1].map((side) => regionPath(model.regions[id], shown.frame, side));
    draw("path", { class: "ghost", d: far }, ball);
    draw("path", { class: "mark outline", d: near }, ball);
    const [cx, cy] = spot(shown.turned[id]).split(",");
    draw("circle", { class: "mark ring", cx, cy, r: 6 }, dual);
  } else if (kind === "arc") {
    for (const side of [-1, 1]) {
      const d = model.arcs[id].pieces.map((piece) => visible(shown.frame[piece], side)).join("");
      draw("path", { class: side > 0 ? "mark" : "mark hidden", d }, ball);
    }
  } else {
    const p = turned(state.axes, data.points[model.points[id].piece].unit);
    const [cx, cy] = spot(p).split(",");
    draw("circle", { class: p[2] >= 0 ? "mark spot" : "mark spot hidden", cx, cy, r: 3.6 }, ball);
  }
}

function describe(chosen) {
  at("start").hidden = Boolean(chosen);
  at("told").classList.toggle("active", Boolean(chosen));
  at("front").disabled = !chosen;
  at("clear").disabled = !state.kept;
  const title = at("chosen-title");
  if (!chosen) {
    title.textContent = "Nothing chosen";
    facts(at("chosen"), []);
    return;
  }
  if (chosen.kind === "region") {
    const region = model.regions[chosen.id];
    title.textContent = "A region, a vertex of the dual";
    facts(at("chosen"), [
      ["signs", region.signs || "(no plane)", true],
      ["a point inside", tuple(data.regions[region.pieces[0]].witness), true],
      ["sides", String(region.arcs.length)],
      ["dual vertex, normals as given", tuple(dualVertex(model, region)), true],
    ]);
  } else if (chosen.kind === "arc") {
    const arc = model.arcs[chosen.id];
    title.textContent = "An arc, an edge of the dual";
    facts(at("chosen"), [
      ["signs", arc.signs, true],
      ["a point inside", tuple(data.arcs[arc.pieces[0]].witness), true],
      ["on", planesOf(arc.circle)],
      ["between", `${model.regions[arc.left].signs} and ${model.regions[arc.right].signs}`, true],
    ]);
  } else {
    const point = model.points[chosen.id];
    title.textContent = "A crossing, a face of the dual";
    facts(at("chosen"), [
      ["signs", point.signs, true],
      ["direction", tuple(data.points[point.piece].ray), true],
      ["planes through it", point.circles.map(planesOf).join("; ")],
      ["regions around it", String(point.cycle.length)],
    ]);
  }
}

function planesOf(circle) {
  const members = data.classes[circle].filter((k) => state.on[k]).map((k) => k + 1);
  return `${members.length > 1 ? "planes" : "plane"} ${members.join(" = ")}`;
}
