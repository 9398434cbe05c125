// The plane of forces at the torque of the load.
const CODES = { stick: "●", "slip+": "+", "slip-": "−", detached: "○" };

const outline = (corners) => `M${corners.map((p) => onPaper(p).map(fixed).join(",")).join("L")}Z`;

// A rectangle of the plane, somewhat larger than what is seen.
const seen = () => cornersOf(frame(1.15));

const stuck = (piece) => Math.min(3, piece.states.filter((s) => s === "stick").length);
const codeOf = (states) => states.map((s) => CODES[s]).join("");

// Below all fills lies a broad line around every piece. What is left of it is the boundary of the
// union: there, and only there, resistance ends.
function paintPlane(view) {
  const { solid, thin } = partsSeen(state.pieces);
  const sheets = solid.map(({ corners }) => corners.map(onPaper));
  view.replaceChildren();
  hatching(view);
  paintGrid(view, 0);
  for (const { corners } of solid) draw("path", { class: "rim", d: outline(corners) }, view);
  for (const { piece, corners } of solid) {
    draw("path", { class: `piece s${stuck(piece)}`, d: outline(corners), "data-states": String(piece.states) }, view);
    if (piece.states.includes("detached")) {
      draw("path", { class: "hatched", d: outline(corners), fill: "url(#hatch)" }, view);
    }
  }
  for (const { corners } of solid) draw("path", { class: "seam", d: outline(corners) }, view);
  for (const { corners } of thin) if (!covered(corners, sheets)) paintThin(view, corners);
  paintGrid(view, 1);
  paintCodes(view, solid);
}

// What is seen of pieces, the largest first: polygons, and what has no area.
function partsSeen(list) {
  const box = seen();
  const tiny = 1e-9 / (scale() * scale());
  const parts = list.map((piece) => {
    const corners = slice(piece, box);
    return { piece, corners, area: areaOf(corners) };
  }).filter(({ corners }) => corners.length).sort((one, other) => other.area - one.area);
  return { solid: parts.filter(({ area }) => area > tiny), thin: parts.filter(({ area }) => area <= tiny) };
}

function hatching(view) {
  const pattern = draw("pattern", { id: "hatch", width: 5, height: 5, patternUnits: "userSpaceOnUse",
    patternTransform: "rotate(45)" }, draw("defs", {}, view));
  draw("path", { d: "M0 0V5", stroke: "var(--ink)", "stroke-width": 0.5, opacity: 0.45 }, pattern);
}

// Whether the ends and the middle of a thin piece lie in polygons, so that it adds nothing.
function covered(corners, sheets) {
  const places = corners.map(onPaper);
  return [...places, middleOfAll(places)].every((p) => sheets.some((sheet) => within(sheet, p)));
}

function paintThin(view, corners) {
  const places = corners.map(onPaper);
  const far = places.reduce((best, p) => (Math.hypot(p[0] - places[0][0], p[1] - places[0][1])
    > Math.hypot(best[0] - places[0][0], best[1] - places[0][1]) ? p : best), places[0]);
  const [x, y] = places[0];
  if (Math.hypot(far[0] - x, far[1] - y) < 0.5) {
    draw("circle", { class: "lone", cx: fixed(x), cy: fixed(y), r: 2 }, view);
  } else {
    draw("path", { class: "thin", d: `M${fixed(x)},${fixed(y)}L${far.map(fixed).join(",")}` }, view);
  }
}

function niceStep(least) {
  const power = Math.floor(Math.log10(least));
  for (const [digit, exponent] of [[1, power], [2, power], [5, power], [1, power + 1]]) {
    if (digit * 10 ** exponent >= least * (1 - 1e-9)) return [digit, exponent];
  }
  return [1, power + 1];
}

function paintGrid(view, layer) {
  const [digit, exponent] = niceStep(34 / scale());
  const step = digit * 10 ** exponent;
  const letters = letterSize(view, 7);
  const label = (k) => (exponent < 0 ? (k * step).toFixed(-exponent) : String(k * step)).replace("-", "−");
  for (const axis of [0, 1]) {
    const { low, high } = frame();
    const [from, to] = [Math.ceil(low[axis] / step), Math.floor(high[axis] / step)];
    for (let k = from; k <= to; k += 1) {
      const place = onPaper(axis ? [0, k * step] : [k * step, 0])[axis];
      const d = axis ? `M${-WIDE},${fixed(place)}H${WIDE}` : `M${fixed(place)},${-HIGH}V${HIGH}`;
      if (layer === 0) draw("path", { class: "grid", d }, view);
      else if (k === 0) draw("path", { class: "axis", d }, view);
      const [x, y] = axis ? [-WIDE + 3, place + 2] : [place, HIGH - 3];
      const room = axis ? Math.abs(place) < HIGH - 14 : Math.abs(place) < WIDE - 16;
      if (layer && room) {
        draw("text", { class: "tick", "font-size": letters, x: fixed(x), y: fixed(y), "text-anchor": axis ? "start" : "middle" }, view, label(k));
      }
    }
  }
  if (!layer) return;
  draw("text", { class: "tick", "font-size": letters, x: WIDE - 4, y: HIGH - letters - 5, "text-anchor": "end" }, view, data.axes[0]);
  draw("text", { class: "tick", "font-size": letters, x: -WIDE + 3, y: -HIGH + letters + 1 }, view, data.axes[1]);
}

// The states as one character for each contact, where they fit and nothing covers them.
function paintCodes(view, solid) {
  const letters = letterSize(view, 9);
  solid.forEach(({ piece, corners }, i) => {
    const places = clippedToSight(corners).map(onPaper);
    if (places.length < 3) return;
    const later = solid.slice(i + 1).map((other) => other.corners.map(onPaper));
    paintCode(view, middleOfAll(places), piece.states, letters, (p) => within(places, p) && !later.some((other) => within(other, p)));
  });
}

// A size of letters, in units of a picture, that is at least 11 pixels on the screen.
const letterSize = (view, least) => Math.max(least, 11.2 / (view.getScreenCTM()?.a || 1));

// The states at a place, if the middle and the corners of their box pass.
/** @type {(view: Element, middle: number[], states: string[], size: number, passes: (p: number[]) => boolean) => void} */
function paintCode(view, [x, y], states, size, passes) {
  const [w, h] = [0.4 * size * states.length + 0.5, 0.42 * size];
  if ([[0, 0], [-w, -h], [w, -h], [w, h], [-w, h]].every(([dx, dy]) => passes([x + dx, y + dy]))) {
    draw("text", { class: "code", "font-size": size, x: fixed(x), y: fixed(y) }, view, codeOf(states));
  }
}

function clippedToSight(corners) {
  const { low, high } = frame();
  return [[1, 0, -low[0]], [-1, 0, high[0]], [0, 1, -low[1]], [0, -1, high[1]]].reduce((left, row) => cut(left, row, 0), corners);
}

// Whether a point of the paper is in a convex polygon, or nearly.
/** @type {(places: number[][], point: number[]) => boolean} */
function within(places, [x, y]) {
  const turns = places.map((p, i) => {
    const q = places[(i + 1) % places.length];
    const length = Math.hypot(q[0] - p[0], q[1] - p[1]) || 1;
    return ((q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0])) / length;
  });
  return turns.every((t) => t <= 0.05) || turns.every((t) => t >= -0.05);
}

// The load: a dot where it is resisted, else a cross; with the piece that it is in.
function paintLoadHere(view, resisted, piece) {
  if (piece) draw("path", { class: "held-piece", d: outline(slice(piece, seen())) }, view);
  const [x, y] = onPaper(floatsOf(state.wrench.slice(0, 2)));
  const [ox, oy] = onPaper([0, 0]);
  draw("path", { class: "here line", d: `M${fixed(ox)},${fixed(oy)}L${fixed(x)},${fixed(y)}` }, view);
  if (resisted) draw("circle", { class: "here dot", cx: fixed(x), cy: fixed(y), r: 3.4 }, view);
  else draw("path", { class: "here", d: `M${fixed(x - 3)},${fixed(y - 3)}l6,6m0,-6l-6,6` }, view);
}

// The part of a piece in a rectangle of the plane of forces, as corners: a polygon, two or one.
function slice(piece, box) {
  const [, , torque] = state.wrench;
  const line = ({ float: [a, b, c, d] }) => [a, b, c * near(torque) + d];
  let corners = box;
  const tolerance = 1e-9 * Math.max(...box.flat().map(Math.abs));
  for (const row of piece.equal) {
    if (same(row.exact[0], ZERO) && same(row.exact[1], ZERO)) {
      if (dotted(row.exact, [ZERO, ZERO, torque, ONE]).n !== 0n) return [];
      continue;
    }
    corners = onLine(corners, line(row));
  }
  for (const row of piece.atLeast) corners = cut(corners, line(row), tolerance);
  return corners;
}

// Where a line meets a convex polygon: two ends, or one.
/** @type {(corners: number[][], row: number[]) => number[][]} */
function onLine(corners, [a, b, c]) {
  const length = Math.hypot(a, b);
  /** @type {(p: number[]) => number} */ const height = ([x, y]) => (a * x + b * y + c) / length;
  const found = [];
  corners.forEach((p, i) => {
    const q = corners[(i + 1) % corners.length];
    const [s, t] = [height(p), height(q)];
    if (Math.abs(s) < 1e-9) found.push(p);
    else if (s * t < 0 && Math.abs(t) >= 1e-9) {
      const share = s / (s - t);
      found.push([p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])]);
    }
  });
  return found.filter((p, i) => found.findIndex((q) => Math.hypot(p[0] - q[0], p[1] - q[1]) < 1e-9) === i).slice(0, 2);
}

const areaOf = (corners) => Math.abs(area(corners)) / 2;
const middleOfAll = (places) => [0, 1].map((k) => places.reduce((sum, p) => sum + p[k], 0) / places.length);

// The nearest round decimals: so the force under the pointer is exact.
function forceStep() {
  const [digit, exponent] = niceStep(1.6 / scale());
  return exponent >= 0 ? ratio(BigInt(digit) * 10n ** BigInt(exponent)) : ratio(BigInt(digit), 10n ** BigInt(-exponent));
}

function rounded(value) {
  const step = forceStep();
  return times(step, ratio(BigInt(Math.round(value / near(step)))));
}

// The plane fills its frame, whatever its shape.
function fit() {
  const { width, height } = at("plane").getBoundingClientRect();
  const least = Math.min(width, height) || 1;
  const [wide, high] = [(SIDE * (width || 1)) / least, (SIDE * (height || 1)) / least];
  at("plane").setAttribute("viewBox", `${-wide} ${-high} ${2 * wide} ${2 * high}`);
  readSides();
  refresh();
}
