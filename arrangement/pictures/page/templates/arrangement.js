// The page: one rotation for both drawings, one thing under the pointer, one thing kept.
const state = {
  even: Boolean(data.even?.at_first), axes: null, on: data.planes.map(() => true), colour: null,
  under: null, kept: null, spinning: false,
};
const arcsOf = data.classes.map((_, circle) => data.arcs.flatMap((arc, k) => (arc.circle === circle ? [k] : [])));
let model = modelOf(state.on);
state.colour = data.colour ?? (new Set(model.regions.map((region) => region.arcs.length)).size > 1 ? "sides" : "parity");
const shown = { sphere: {}, dual: {} };
const refresh = oncePerFrame(paint);

function rebuild() {
  model = modelOf(state.on);
  shown.places = dualPlaces(model, at("unit").checked);
  state.under = null;
  buildSphere();
  buildDual();
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

function buildSphere() {
  const view = at("sphere");
  view.replaceChildren();
  const part = shown.sphere;
  const colour = colourOf(model, state.colour);
  draw("circle", { class: "ball", r: RADIUS }, view);
  part.regions = model.regions.map((region, id) =>
    draw("path", { class: `region ${colour(region)}`, "data-kind": "region", "data-id": id }, view));
  part.ghost = draw("path", { class: "ghost" }, view);
  part.back = [];
  part.front = [];
  for (const [side, list] of [["back", part.back], ["front", part.front]]) {
    data.classes.forEach((members, circle) => {
      if (!model.classOn[circle]) return;
      const path = draw("path", { class: `circle ${side}`, "data-circle": circle }, view);
      list.push(tinted(path, circle));
    });
  }
  draw("circle", { class: "limb", r: RADIUS }, view);
  part.lit = draw("g", {}, view);
  part.text = draw("g", {}, view);
}

function buildDual() {
  const view = at("dual");
  view.replaceChildren();
  const part = shown.dual;
  const colour = colourOf(model, state.colour);
  // Layers from the back to the front; the first face layer stays empty.
  part.layers = [false, true].map(() => [0, 1, 2].map(() => draw("g", {}, view)));
  part.shownAt = [[], [], []];
  const item = (name, kind, id, style) => draw(name, { class: style, "data-kind": kind, "data-id": id });
  part.faces = model.points.map((point, id) => item("path", "point", id, "face"));
  part.edges = model.arcs.map((arc, id) => tinted(item("path", "arc", id, "edge"), arc.circle));
  part.vertices = model.regions.map((region, id) => item("circle", "region", id, `vertex ${colour(region)}`));
  part.text = draw("g", {}, view);
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
  paintSphere();
  paintDual();
  paintChoice();
}

function paintSphere() {
  const part = shown.sphere;
  const frame = curves.map((curve) => curve.map((p) => turned(state.axes, p)));
  shown.frame = frame;
  part.regions.forEach((path, id) => path.setAttribute("d", regionPath(model.regions[id], frame, 1)));
  for (const [list, side] of [[part.front, 1], [part.back, -1]]) {
    for (const path of list) {
      const circle = Number(path.dataset.circle);
      path.setAttribute("d", arcsOf[circle].map((arc) => visible(frame[arc], side)).join(""));
    }
  }
  part.text.replaceChildren();
  for (const entry of limbNumbers(model, state.axes)) {
    const [c, s, x, y] = [Math.cos(entry.shown), Math.sin(entry.shown), Math.cos(entry.angle), Math.sin(entry.angle)];
    draw("path", { class: "lead", d: `M${spot([x, y])}L${spot([1.06 * c, 1.06 * s])}` }, part.text);
    tinted(draw("text", { class: "number", x: 112 * c, y: -112 * s + 2.6 }, part.text, entry.text), entry.circle);
  }
  if (at("labels").checked) labelRegions(part.text);
}

function labelRegions(group) {
  for (const region of model.regions) {
    const room = roomOf(model, region);
    const p = turned(state.axes, region.inside);
    if (p[2] > 0.15 && 1.9 * region.signs.length < room * p[2] * RADIUS) {
      draw("text", { class: "tag", x: fixed(RADIUS * p[0]), y: fixed(-RADIUS * p[1]) }, group, minus(region.signs));
    }
  }
}

function paintDual() {
  const part = shown.dual;
  const places = shown.places.map((p) => turned(state.axes, p));
  shown.turned = places;
  const frontFaces = model.points.map((point) => area(point.cycle.map((id) => places[id])) > 1e-9);
  const none = !frontFaces.some(Boolean);
  const corners = new Set(model.points.flatMap((point, i) => (frontFaces[i] ? point.cycle : [])));
  const sides = new Set(model.points.flatMap((point, i) => (frontFaces[i]
    ? point.cycle.map((id, k) => pairOf(id, point.cycle[(k + 1) % point.cycle.length])) : [])));
  const flat = none || model.points.length <= 2;
  const inFront = [
    frontFaces, model.arcs.map((arc) => flat || sides.has(pairOf(arc.left, arc.right))),
    model.regions.map((_, id) => flat || corners.has(id)),
  ];
  part.faces.forEach((path, i) => {
    path.setAttribute("d", `M${model.points[i].cycle.map((id) => spot(places[id])).join("L")}Z`);
  });
  part.edges.forEach((path, i) => {
    const arc = model.arcs[i];
    path.setAttribute("d", `M${spot(places[arc.left])}L${spot(places[arc.right])}`);
  });
  const size = Math.max(1.6, Math.min(4, 24 / Math.sqrt(model.regions.length)));
  part.vertices.forEach((circle, i) => {
    circle.setAttribute("cx", fixed(RADIUS * places[i][0]));
    circle.setAttribute("cy", fixed(-RADIUS * places[i][1]));
    circle.setAttribute("r", size * (inFront[2][i] ? 1 : 0.7));
  });
  [part.faces, part.edges, part.vertices].forEach((list, level) => list.forEach((element, i) => {
    const ahead = inFront[level][i];
    if (part.shownAt[level][i] === ahead) return;
    part.shownAt[level][i] = ahead;
    element.classList.toggle("back", !ahead);
    if (level === 0 && !ahead) element.remove();
    else part.layers[Number(ahead)][level].append(element);
  }));
  part.text.replaceChildren();
  if (at("labels").checked) labelVertices(part.text, places, inFront[2]);
}

const minus = (signs) => signs.replaceAll("-", "\u2212");
const pairOf = (a, b) => (a < b ? `${a} ${b}` : `${b} ${a}`);

function labelVertices(group, places, inFront) {
  const taken = [];
  const order = places.map((_, id) => id).filter((id) => inFront[id]).sort((a, b) => places[b][2] - places[a][2]);
  for (const id of order) {
    const [x, y] = places[id];
    const half = 1.9 * model.regions[id].signs.length;
    const n = Math.hypot(x, y) || 1;
    const middle = [RADIUS * x + (x / n) * (half + 3), RADIUS * y + (y / n) * 7];
    const clash = taken.some(([u, v, w]) => Math.abs(u - middle[0]) < w + half && Math.abs(v - middle[1]) < 6.5);
    if (clash || Math.abs(middle[0]) + half > 124) continue;
    taken.push([...middle, half]);
    draw("text", { class: "tag", x: fixed(middle[0]), y: fixed(-middle[1]) }, group, minus(model.regions[id].signs));
  }
}

function paintChoice() {
  const chosen = state.under ?? state.kept;
  for (const element of document.querySelectorAll(".lit")) element.classList.remove("lit");
  shown.sphere.lit.replaceChildren();
  shown.sphere.ghost.setAttribute("d", "");
  for (const item of [state.kept, state.under]) if (item) light(item);
  describe(chosen);
  at("regions").value = chosen?.kind === "region" ? String(chosen.id) : "";
}

function light({ kind, id }) {
  const { sphere, dual } = shown;
  if (kind === "region") {
    sphere.regions[id].classList.add("lit");
    dual.vertices[id].classList.add("lit");
    draw("path", { class: "mark outline", d: sphere.regions[id].getAttribute("d") }, sphere.lit);
    sphere.ghost.setAttribute("d", regionPath(model.regions[id], shown.frame, -1));
    const [x, y] = shown.turned[id];
    draw("circle", { class: "mark ring", cx: fixed(RADIUS * x), cy: fixed(-RADIUS * y), r: 6 }, dual.text);
  } else if (kind === "arc") {
    dual.edges[id].classList.add("lit");
    for (const side of [-1, 1]) {
      const d = model.arcs[id].pieces.map((piece) => visible(shown.frame[piece], side)).join("");
      draw("path", { class: side > 0 ? "mark" : "mark hidden", d }, sphere.lit);
    }
  } else {
    dual.faces[id].classList.add("lit");
    const p = turned(state.axes, data.points[model.points[id].piece].unit);
    const style = p[2] >= 0 ? "mark spot" : "mark spot hidden";
    draw("circle", { class: style, cx: fixed(RADIUS * p[0]), cy: fixed(-RADIUS * p[1]), r: 3.6 }, sphere.lit);
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
