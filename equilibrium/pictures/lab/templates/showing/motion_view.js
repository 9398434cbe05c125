// The motions of two slices, r = turn and r = -turn, by their centres of rotation: the object's plane seen as half a
// ball, counter-clockwise on the left, clockwise on the right. The rim stands for translations.
const DISC = { 1: [-107, 0], [-1]: [107, 0] };
const DISC_RADIUS = 96;

// The planes of a slice r = way * turn, as rows in (x, y, h): the motion is turn (x, y, way h) / h.
function sliceRows(grasp, turn, way) {
  const sign = ratio(BigInt(way));
  return grasp.map((contact) => {
    const { N, T } = wrenchesOf(contact);
    const stiff = times(contact.stiffness, turn);
    return {
      slip: integers([T[0], T[1], times(sign, T[2])]).row,
      spring: integers([times(minus(stiff), N[0]), times(minus(stiff), N[1]),
        less(contact.preload, times(times(sign, stiff), N[2]))]).row,
    };
  });
}

// A ray (x, y, h) of a slice as a direction in which the third axis is the object's middle.
/** @type {(ray: number[], way: number) => number[]} */
const directionOf = ([x, y, h], way) => unit([-way * y - data.centre[0] * h, way * x - data.centre[1] * h, 1.2 * data.size * h]);
// A row of a slice as a normal there.
/** @type {(row: number[], way: number) => number[]} */
const normalOf = ([a, b, c], way) => unit([-way * b, way * a, (way * (a * data.centre[1] - b * data.centre[0]) + c) / (1.2 * data.size)]);
/** @type {(v: number[], way: number) => number[]} */
const onDisc = (v, way) => [DISC[way][0] + DISC_RADIUS * v[0], DISC[way][1] - DISC_RADIUS * v[1]];
/** @type {(point: number[], way: number) => number[]} */
const fromDisc = ([x, y], way) => [(x - DISC[way][0]) / DISC_RADIUS, (DISC[way][1] - y) / DISC_RADIUS];

// The regions that rows make in a slice, h > 0: the sign of each row, the walls with their sides, and an outline on
// the disc.
function regionsOf(rows, way) {
  const all = gathered(rows, [0n, 0n, 1n]);
  const { circles, infinity } = all;
  const corner = (p) => pointOf(circles, p, (ray) => directionOf(floats(ray), way));
  const normals = circles.normals.map((row) => normalOf(floats(row), way));
  const curves = circles.arcs.map(({ circle, from, to }) => curveOf(normals[circle], corner(from), corner(to)));
  return facesOf(all).regions.map(({ key, darts }) => ({
    signs: planeSigns(all, [...key].map((s) => (s === "+" ? 1 : -1))),
    walls: darts.map((dart) => circles.arcs[dart >> 1].circle).filter((i) => i !== infinity)
      .map((i) => normals[i].map((x) => (key[i] === "+" ? x : -x))),
    outline: boundaryOf(darts, curves).map((v) => onDisc(v, way)),
  }));
}

// The cells of a slice by contact states: their regions lie apart, or differ in the slip of contacts that do not touch.
function cellsOf(grasp, turn, way) {
  const rows = sliceRows(grasp, turn, way);
  const regions = regionsOf(rows.flatMap(({ slip, spring }) => [slip, spring]), way);
  const stateOf = (slip, spring) => (spring < 0 ? "detached" : slip > 0 ? "slip+" : "slip-");
  const cells = Map.groupBy(regions, ({ signs }) => rows.map((_, i) => stateOf(signs[2 * i], signs[2 * i + 1])).join());
  return [...cells].map(([text, parts]) => ({ way, states: text ? text.split(",") : [], parts }));
}

// The regions that the first planes make, for Algorithm 1.
function firstCells({ planes, count: number }) {
  const contacts = planes.slice(0, number).map((plane) => state.grasp[plane.contacts[0]]);
  return [1, -1].flatMap((way) => {
    const rows = sliceRows(contacts, ONE, way).map(({ slip }) => slip);
    return regionsOf(rows, way).map((part) => ({ way, states: part.signs.map((s) => (s > 0 ? "slip+" : "slip-")), parts: [part] }));
  });
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
  if (state.cells?.key !== key) state.cells = { key, list: [1, -1].flatMap((way) => cellsOf(state.grasp, state.turnSize(), way)) };
  return state.cells.list;
}

function paintDiscs() {
  const view = at("discs");
  const letters = letterSize(view, 13);
  view.replaceChildren();
  const step = player.step?.kind === "planes" ? player.step : null;
  for (const way of [1, -1]) {
    draw("circle", { class: "disc", cx: DISC[way][0], cy: 0, r: DISC_RADIUS, fill: "var(--panel)" }, view);
  }
  for (const cell of step ? firstCells(step) : slices()) paintCell(view, cell, letters);
  for (const way of [1, -1]) {
    sliceRows(state.grasp, state.turnSize(), way).forEach((rows, i) => {
      const place = step ? step.order.indexOf(i) : 0;
      if (step && (place < 0 || place >= step.count)) return;
      paintCircle(view, rows.slip, way, `circle${step && place === step.count - 1 ? " fresh" : ""}`, i);
      if (!step) paintCircle(view, rows.spring, way, "circle normal-line", i);
    });
    const [x] = DISC[way];
    draw("circle", { class: "disc rim-line", cx: x, cy: 0, r: DISC_RADIUS }, view);
    const [sign, words] = way > 0 ? ["↺", "counter-clockwise"] : ["↻", "clockwise"];
    draw("text", { class: "small", "font-size": letters, x, y: DISC_RADIUS + 14 }, view, letters > 18 ? sign : `${sign} ${words}`);
  }
  const piece = state.shownPiece();
  if (piece) paintDot(view, piece.motion.map(near), "dot");
  const shown = state.motion || !piece ? state.shownMotion() : null;
  if (shown) paintDot(view, shown.motion.map(near), "dot choice");
}

// A group in the colour of a cell.
function cellGroup(view, { states }, style) {
  const group = draw("g", { class: style, "data-states": String(states) }, view);
  group.style.fill = group.style.stroke = colourOf(states);
  return group;
}

function paintCell(view, cell, letters) {
  const group = cellGroup(view, cell, "cell disc");
  for (const part of cell.parts) draw("path", { d: `${pathOf(part.outline)}Z` }, group);
  const largest = cell.parts.reduce((best, part) => (areaOf(part.outline) > areaOf(best.outline) ? part : best));
  paintCode(view, middleOfAll(largest.outline), cell.states, letters, (p) => {
    const [u, v] = fromDisc(p, cell.way);
    return Math.hypot(u, v) < 1 && largest.walls.every((n) => dot(n, [u, v, Math.sqrt(1 - u * u - v * v)]) > 0);
  });
}

// Half a great circle: where a row vanishes.
function paintCircle(view, row, way, style, i) {
  const normal = normalOf(floats(row), way);
  if (Math.hypot(normal[0], normal[1]) < 1e-12) return;
  const start = unit([-normal[1], normal[0], 0]);
  const points = curveOf(normal, start, start.map((x) => -x));
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
  const [u, v] = fromDisc([x, -y], way);
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

// The regions of rotation centres, in the object's plane: a direction v is the centre 1.2 v / v[2].
function paintRegions(view) {
  const way = state.turn.n < 0n ? -1 : 1;
  for (const cell of slices().filter((one) => one.way === way)) {
    const group = cellGroup(view, cell, "cell");
    for (const { walls } of cell.parts) {
      const corners = walls.reduce((left, [a, b, c]) => cut(left, [a, b, 1.2 * c], 0), [[-2.2, -1.9], [2.2, -1.9], [2.2, 1.9], [-2.2, 1.9]]);
      if (corners.length > 2) draw("path", { d: `M${corners.map(sketched).join("L")}Z` }, group);
    }
  }
}
