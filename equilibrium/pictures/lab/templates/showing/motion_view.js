// The motions of a slice by their centres of rotation: the object's plane seen as half a sphere,
// counter-clockwise on the left, clockwise on the right. The rim stands for translations.
const DISC = { 1: [-107, 0], [-1]: [107, 0] };
const RADIUS = 96;

// A ray (x, y, h) of a slice as a direction in which the third axis is the object's middle.
/** @type {(ray: number[], way: number) => number[]} */
function directionOf([x, y, h], way) {
  const v = [-way * y - data.centre[0] * h, way * x - data.centre[1] * h, 1.2 * data.size * h];
  const length = Math.hypot(...v) || 1;
  return v.map((c) => c / length);
}

/** @type {(v: number[], way: number) => number[]} */
const onDisc = (v, way) => [DISC[way][0] + RADIUS * v[0], DISC[way][1] - RADIUS * v[1]];
// The ray of a slice at a place of its disc; null outside.
/** @type {(point: number[], way: number) => number[] | null} */
function rayAt([px, py], way) {
  const [u, v] = [(px - DISC[way][0]) / RADIUS, (DISC[way][1] - py) / RADIUS];
  const w = Math.sqrt(1 - u * u - v * v);
  if (!(w > 0)) return null;
  const h = w / (1.2 * data.size);
  return [way * (v + data.centre[1] * h), -way * (u + data.centre[0] * h), h];
}

// Points of the great arc between two directions.
function arcOf(a, b) {
  const angle = Math.acos(Math.min(1, Math.max(-1, a[0] * b[0] + a[1] * b[1] + a[2] * b[2])));
  const steps = Math.max(1, Math.ceil(angle / 0.1));
  return Array.from({ length: steps }, (_, k) => {
    const v = a.map((x, i) => (angle < 1e-9 ? x : (Math.sin((1 - k / steps) * angle) * x + Math.sin((k / steps) * angle) * b[i]) / Math.sin(angle)));
    return v;
  });
}

function outlineOfPart(part, way) {
  const corners = part.map((ray) => directionOf(floats(ray), way));
  return corners.flatMap((v, i) => arcOf(v, corners[(i + 1) % corners.length])).map((v) => onDisc(v, way));
}

// A fill for each choice of states; the less is in touch, the paler.
function colourOf(states) {
  if (states.every((s) => s === "detached")) return "var(--panel)";
  const code = states.reduce((sum, s) => sum * 4 + STATES.indexOf(s) + 1, 0);
  const touching = states.filter((s) => s !== "detached").length / states.length;
  return `oklch(var(--cell-l) calc(var(--cell-c) * ${(0.35 + 0.65 * touching).toFixed(2)}) ${(code * 137.508) % 360})`;
}

// The cells of both slices; kept until grasp or turn change.
function slices() {
  const key = `${hashOf(state.grasp, state.wrench).split("|")[1]}@${textOf(state.turnSize())}`;
  if (state.cells?.key !== key) {
    const list = [1, -1].flatMap((way) => cellsOf(state.grasp, state.turnSize(), way));
    for (const cell of list) cell.outlines = cell.parts.map((part) => outlineOfPart(part, cell.way));
    state.cells = { key, list };
  }
  return state.cells.list;
}

function paintDiscs() {
  const view = at("discs");
  view.replaceChildren();
  const step = player.step?.kind === "planes" ? player.step : null;
  for (const way of [1, -1]) {
    draw("circle", { class: "disc", cx: DISC[way][0], cy: 0, r: RADIUS, fill: "var(--panel)" }, view);
  }
  for (const cell of step ? regionsOf(step) : slices()) paintCell(view, cell);
  for (const way of [1, -1]) {
    sliceRows(state.grasp, state.turnSize(), way).forEach((rows, i) => {
      const place = step ? step.order.indexOf(i) : 0;
      if (step && (place < 0 || place >= step.count)) return;
      paintCircle(view, rows.slip, way, `circle${step && place === step.count - 1 ? " fresh" : ""}`, i);
      if (!step) paintCircle(view, rows.spring, way, "circle normal-line", i);
    });
    const [x] = DISC[way];
    draw("circle", { class: "disc rim-line", cx: x, cy: 0, r: RADIUS }, view);
    draw("text", { class: "small", x, y: RADIUS + 13 }, view, way > 0 ? "↺ counter-clockwise" : "↻ clockwise");
  }
  const piece = state.shownPiece();
  if (piece) paintDot(view, piece.motion.map(near), "dot");
  const shown = state.motion || !piece ? state.shownMotion() : null;
  if (shown) paintDot(view, shown.motion.map(near), "dot choice");
}

// The regions that the first planes make, for Algorithm 1.
function regionsOf({ planes, count: number }) {
  const contacts = planes.slice(0, number).map((plane) => state.grasp[plane.contacts[0]]);
  return [1, -1].flatMap((way) => {
    const rows = sliceRows(contacts, ONE, way).map(({ slip }) => slip);
    const regions = Map.groupBy(partsOf(rows), (part) => rows.map((row) => (dotOf(row, inside(part)) > 0n ? "slip+" : "slip-")).join());
    return [...regions].map(([states, parts]) => ({ way, rows, states: states.split(","), outlines: parts.map((part) => outlineOfPart(part, way)) }));
  });
}

function paintCell(view, cell) {
  const group = draw("g", { class: "cell disc", "data-states": String(cell.states) }, view);
  group.style.fill = colourOf(cell.states);
  group.style.stroke = colourOf(cell.states);
  for (const outline of cell.outlines) draw("path", { d: `${pathOf(outline)}Z` }, group);
  const areas = cell.outlines.map(areaOf);
  const whole = areas.reduce((sum, area) => sum + area, 0);
  const middle = [0, 1].map((k) => cell.outlines.reduce((sum, points, i) => sum
    + (areas[i] / whole) * (points.reduce((all, p) => all + p[k], 0) / points.length), 0));
  const [w, h] = [3 * cell.states.length + 1, 5];
  const frame = [[-w, -h], [w, -h], [w, h], [-w, h]].map(([x, y]) => [middle[0] + x, middle[1] + y]);
  const rows = cell.rows.map((row) => floats(row));
  const signs = (p) => { const ray = rayAt(p, cell.way); return ray && rows.map((row) => Math.sign(row.reduce((sum, x, k) => sum + x * ray[k], 0))).join(); };
  const here = signs(middle);
  if (here && frame.every((p) => signs(p) === here)) {
    draw("text", { class: "code", x: fixed(middle[0]), y: fixed(middle[1]) }, view, codeOf(cell.states));
  }
}

// Half a great circle: where a row vanishes.
function paintCircle(view, row, way, style, i) {
  const [a, b, c] = floats(row);
  const flat = Math.hypot(a, b);
  if (flat < 1e-12) return;
  const ends = [[-b, a, 0], [-a * c, -b * c, flat * flat], [b, -a, 0]].map((ray) => directionOf(ray, way));
  const points = [...arcOf(ends[0], ends[1]), ...arcOf(ends[1], ends[2]), ends[2]];
  draw("path", { class: style, "data-contact": i, d: pathOf(points.map((v) => onDisc(v, way))) }, view);
}

function paintDot(view, [x, y, r], style) {
  if (!r && !x && !y) return;
  for (const way of r ? [Math.sign(r)] : [1, -1]) {
    const [px, py] = onDisc(directionOf([x, y, Math.abs(r)], way), way);
    draw("circle", { class: style, cx: fixed(px), cy: fixed(py), r: 3.2 }, view);
  }
}

// The motion under the pointer, rounded to a round centre of rotation; null outside of the discs.
function motionUnder(event) {
  const [x, y] = place(at("discs"), event);
  const way = x < 0 ? 1 : -1;
  const [u, v] = [(x - DISC[way][0]) / RADIUS, (y + DISC[way][1]) / RADIUS];
  const w = Math.sqrt(Math.max(0, 1 - u * u - v * v));
  if (Math.hypot(u, v) > 1.02 || w < 0.03) return null;
  return rotationAbout([0, 1].map((k) => data.centre[k] + ([u, v][k] / w) * 1.2 * data.size), way);
}

// The exact motion of the slice that turns about a rounded point.
function rotationAbout(point, way) {
  const steps = 2 ** Math.max(3, Math.ceil(4 - Math.log2(data.size)));
  const [x, y] = point.map((c) => onGrid(c, steps));
  const r = times(ratio(BigInt(way)), state.turnSize());
  return [times(y, r), minus(times(x, r)), r];
}

// The regions of rotation centres, in the object's plane.
function paintRegions(view) {
  const way = state.turn.n < 0n ? -1 : 1;
  for (const cell of slices().filter((one) => one.way === way)) {
    const group = draw("g", { class: "cell", "data-states": String(cell.states) }, view);
    group.style.fill = colourOf(cell.states);
    group.style.stroke = colourOf(cell.states);
    for (const part of cell.parts) {
      let corners = part.map((ray) => floats(ray))
        .map(([x, y, h]) => [(-way * y - data.centre[0] * h) / data.size, (way * x - data.centre[1] * h) / data.size, h]);
      for (const row of [[1, 0, 2.2], [-1, 0, 2.2], [0, 1, 1.9], [0, -1, 1.9]]) corners = cutFloats(corners, row);
      if (corners.length > 2) draw("path", { d: `M${corners.map(([x, y, h]) => spot([x / h, y / h])).join("L")}Z` }, group);
    }
  }
}

/** @type {(corners: number[][], row: number[]) => number[][]} */
function cutFloats(corners, row) {
  const height = (v) => row[0] * v[0] + row[1] * v[1] + row[2] * v[2];
  return corners.flatMap((v, i) => {
    const next = corners[(i + 1) % corners.length];
    const [s, t] = [height(v), height(next)];
    const between = () => v.map((x, k) => (s * next[k] - t * x) / (s - t));
    return [...(s >= 0 ? [v] : []), ...(s * t < 0 ? [between()] : [])];
  });
}
