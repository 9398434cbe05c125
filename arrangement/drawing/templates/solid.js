// Convex pieces in space, painted back to front by a tree of planes: exact for every direction.
const view = at("solid");
const state = { axes: data.axes, apart: data.apart ?? 1, zoom: 1, under: null, kept: null, spinning: false };
const chosen = () => state.under ?? state.kept;
const LIGHT = unit([-0.35, 0.65, 0.68]);

// Nodes from the farthest to the nearest.
function* ordered() {
  /** @type {[number, boolean][]} */ const todo = data.nodes.length ? [[0, false]] : [];
  while (todo.length) {
    const [k, ready] = todo.pop();
    if (k < 0) continue;
    const node = data.nodes[k];
    if (ready) { yield node; continue; }
    const ahead = dot(node.row, state.axes[2]) > 0;
    todo.push([ahead ? node.front : node.back, false], [k, true], [ahead ? node.back : node.front, false]);
  }
}

function placed(point, shift) {
  const scale = (100 * state.zoom) / (data.radius * (data.apart ? 0.4 + 0.6 * state.apart : 1));
  const p = point.map((x, i) => x + shift[i]);
  return [scale * dot(state.axes[0], p), -scale * dot(state.axes[1], p)].map((x) => x.toFixed(2));
}

function lit(colour, normal) {
  const white = 0.4 * Math.max(0, dot(LIGHT, state.axes.map((axis) => dot(axis, normal))));
  const mixed = [1, 3, 5].map((k) => parseInt(colour.slice(k, k + 2), 16)).map((x) => Math.round(x + (255 - x) * white));
  return `rgb(${mixed}${colour.length > 7 ? `,${parseInt(colour.slice(7), 16) / 255}` : ""})`;
}

function paint(face, id, shift) {
  const towards = face.normal ? dot(face.normal, state.axes[2]) : 0;
  if (face.normal && !face.sheet && towards <= 0) return;
  const points = face.at.map((p) => placed(p, shift));
  if (points.length > 2) {
    const normal = towards < 0 ? face.normal.map((x) => -x) : face.normal;
    const fill = lit(face.fill, normal);
    const style = { class: id !== null && chosen() === `piece-${id}` ? "face chosen" : "face", d: `M${points.join("L")}Z`, fill, stroke: face.fill.length > 7 ? "none" : fill };
    draw("path", id === null ? style : { ...style, "data-mark": `piece-${id}` }, view);
  } else if (points.length === 1) {
    draw("circle", { cx: points[0][0], cy: points[0][1], r: 1.2 }, view);
  }
  for (const edge of face.edges) {
    const [p, q] = edge.map((end) => placed(end, shift));
    const line = draw("path", { class: face.faint ? "edge faint" : "edge", d: `M${p}L${q}` }, view);
    if (face.ink) line.style.stroke = face.ink;
  }
}

function repaint() {
  view.replaceChildren();
  const rest = [0, 0, 0];
  for (const [p, q] of data.frame) draw("path", { class: "edge faint", d: `M${placed(p, rest)}L${placed(q, rest)}` }, view);
  for (const node of ordered()) {
    for (const face of node.faces) {
      const shift = face.middle ? face.middle.map((x) => x * (state.apart - 1)) : rest;
      paint(face, face.piece, shift);
    }
  }
  for (const { at: point, text } of data.marks) {
    const [x, y] = placed(point, rest);
    draw("text", { x, y }, view, text);
  }
  const piece = data.pieces.find((_, id) => chosen() === `piece-${id}`);
  at("chosen-title").textContent = piece ? piece.name : "Nothing chosen";
  facts(at("chosen"), piece ? piece.facts.map(([name, value]) => [name, value, true]) : []);
  at("start").hidden = Boolean(piece);
}
const refresh = oncePerFrame(repaint);

function zoom(by) {
  state.zoom = Math.min(8, Math.max(0.4, state.zoom * by));
  refresh();
}

function goHome() {
  Object.assign(state, { axes: data.axes, zoom: 1 });
  refresh();
}

const through = (by) => () => step("piece", data.pieces.length, by);
listenToTurns(view, { "+": () => zoom(1.1), "-": () => zoom(1 / 1.1), n: through(1), p: through(-1) });
listenToTurningHead();
view.addEventListener("wheel", (event) => { event.preventDefault(); zoom(Math.exp(-event.deltaY / 800)); });
at("counts").textContent = data.counts;
for (const [colour, text] of data.legend) {
  const line = make("li", {}, at("legend"));
  make("i", {}, line).style.background = colour;
  make("span", {}, line, text);
}
at("slider").hidden = !data.apart;
at("apart").value = state.apart;
at("apart").addEventListener("input", (event) => { state.apart = Number(event.target.value); refresh(); });
repaint();
