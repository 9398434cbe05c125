// Convex pieces in space, painted back to front by a tree of planes: exact for every direction.
const view = at("solid");
const state = { axes: data.axes, apart: data.apart ?? 1, zoom: 1, under: null, kept: null, spinning: false };
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((x) => x / Math.hypot(...a));
const LIGHT = unit([-0.35, 0.65, 0.68]);

function rotate(right, up) {
  const [x, y, z] = state.axes;
  const mix = (u, v, a) => u.map((_, i) => Math.cos(a) * u[i] + Math.sin(a) * v[i]);
  const turned = mix(z, x, -right);
  const ahead = unit(mix(turned, y, -up));
  const side = unit(cross(mix(y, turned, up), ahead));
  state.axes = [side, cross(ahead, side), ahead];
  refresh();
}

// Nodes from the farthest to the nearest.
function* ordered() {
  const todo = data.nodes.length ? [[0, false]] : [];
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
    const style = { class: same(id) ? "face chosen" : "face", d: `M${points.join("L")}Z`, fill, stroke: face.fill.length > 7 ? "none" : fill };
    draw("path", { ...style, "data-id": id }, view);
  } else if (points.length === 1) {
    draw("circle", { cx: points[0][0], cy: points[0][1], r: 1.2 }, view);
  }
  for (const edge of face.edges) {
    const [p, q] = edge.map((end) => placed(end, shift));
    const line = draw("path", { class: face.faint ? "edge faint" : "edge", d: `M${p}L${q}` }, view);
    if (face.ink) line.style.stroke = face.ink;
  }
}

const same = (id) => id !== null && (id === state.under || (state.under === null && id === state.kept));

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
  const chosen = data.pieces[state.under ?? state.kept];
  at("chosen-title").textContent = chosen ? chosen.name : "Nothing chosen";
  facts(at("chosen"), chosen ? chosen.facts.map(([name, value]) => [name, value, true]) : []);
  at("start").hidden = Boolean(chosen);
}
const refresh = oncePerFrame(repaint);

function step(by) {
  const n = data.pieces.length;
  if (n) state.kept = state.kept === null ? (by > 0 ? 0 : n - 1) : (state.kept + by + n) % n;
  state.under = null;
  refresh();
}

function zoom(by) {
  state.zoom = Math.min(8, Math.max(0.4, state.zoom * by));
  refresh();
}

function spin() {
  if (!state.spinning) return;
  rotate(0.006, 0);
  requestAnimationFrame(spin);
}

let held = null;
const pointed = (event) => {
  const id = document.elementFromPoint(event.clientX, event.clientY)?.dataset?.id;
  return id === undefined ? null : Number(id);
};
view.addEventListener("pointerdown", (event) => {
  if (!event.isPrimary || event.button) return;
  held = { x: event.clientX, y: event.clientY, moved: 0 };
  view.setPointerCapture(event.pointerId);
});
view.addEventListener("pointermove", (event) => {
  if (!held) {
    const under = pointed(event);
    if (under !== state.under) { state.under = under; refresh(); }
    return;
  }
  const [dx, dy] = [event.clientX - held.x, event.clientY - held.y];
  held.moved += Math.hypot(dx, dy);
  if (held.moved < 4) return;
  state.under = null;
  const scale = 1 / (100 * view.getScreenCTM().a);
  rotate(dx * scale, dy * scale);
  Object.assign(held, { x: event.clientX, y: event.clientY });
});
view.addEventListener("pointerup", (event) => {
  if (held && held.moved < 4) {
    const found = pointed(event);
    state.kept = found === state.kept ? null : found;
    refresh();
  }
  held = null;
});
view.addEventListener("pointercancel", () => { held = null; });
view.addEventListener("pointerleave", () => { state.under = null; refresh(); });
view.addEventListener("wheel", (event) => { event.preventDefault(); zoom(Math.exp(-event.deltaY / 800)); });
view.addEventListener("keydown", (event) => {
  const keys = {
    ArrowLeft: () => rotate(-0.1, 0), ArrowRight: () => rotate(0.1, 0),
    ArrowUp: () => rotate(0, -0.1), ArrowDown: () => rotate(0, 0.1),
    "+": () => zoom(1.1), "-": () => zoom(1 / 1.1), n: () => step(1), p: () => step(-1),
    Escape: () => { state.kept = null; refresh(); },
  };
  const action = event.ctrlKey || event.metaKey || event.altKey ? null : keys[event.key];
  if (action) { event.preventDefault(); action(); }
});

at("title").textContent = data.title;
at("summary").textContent = data.summary;
at("counts").textContent = data.counts;
for (const [colour, text] of data.legend) {
  const line = make("li", {}, at("legend"));
  make("i", {}, line).style.background = colour;
  make("span", {}, line, text);
}
at("slider").hidden = !data.apart;
at("apart").value = state.apart;
at("apart").addEventListener("input", (event) => { state.apart = Number(event.target.value); refresh(); });
themeButton(at("theme"));
at("print").addEventListener("click", () => window.print());
at("home").addEventListener("click", () => { Object.assign(state, { axes: data.axes, zoom: 1 }); refresh(); });
at("spin").addEventListener("click", () => {
  state.spinning = !state.spinning;
  at("spin").setAttribute("aria-pressed", String(state.spinning));
  spin();
});
repaint();
