// How lines and circles move: exactly, through points of the grid and through crossings.

const gridSteps = () => Number(at("grid").value);

// What a drag may snap to: points where other lines cross.
function targetsWithout(i) {
  const { circles, infinity } = shown().arrangement;
  const others = circles.normals.filter((_, k) => k !== i && k !== infinity);
  return crossingsOf(others).map(({ ray }) => ray);
}

/** @type {(targets: bigint[][], distance: (ray: bigint[]) => number) => { ray: bigint[], gap: number } | undefined} */
const nearest = (targets, distance) => targets.map((ray) => ({ ray, gap: distance(ray) })).sort((a, b) => a.gap - b.gap)[0];

// The exact point for a place of the chart: a crossing nearby, else a point of the grid.
/** @type {(place: number[], targets: bigint[][]) => bigint[]} */
function snapped([X, Y], targets) {
  if (at("magnet").checked) {
    const limit = 7 / scale();
    const distance = (ray) => {
      const [x, y, w] = charted(ray);
      return Math.abs(w) < 1e-9 ? Infinity : Math.hypot(x / w - X, y / w - Y);
    };
    const best = nearest(targets, distance);
    if (best?.gap < limit) return facing(best.ray);
  }
  return facing(primitive(chartOf().snap(X, Y, gridSteps())));
}

// The plane through two points, on the same side of things as before; null if they coincide.
/** @type {(p: bigint[], q: bigint[], before: bigint[]) => bigint[] | null} */
function through(p, q, before) {
  const normal = primitive(crossOf(p, q));
  if (!normal.some((x) => x)) return null;
  const [a, b] = [floats(normal), floats(before)];
  return dot(a, b) < 0 ? opposite(normal) : normal;
}

// The line through a point in the direction that it has.
function shifted(before, point) {
  const far = crossOf(before, chartOf().infinity);
  return far.some((x) => x) ? through(point, far, before) : null;
}

// A circle that is dragged on the ball tilts about what is a quarter turn away. It goes through a
// crossing exactly; elsewhere its normal is rounded, so that numbers stay short.
/** @type {(before: bigint[], direction: number[], targets: bigint[][]) => bigint[] | null} */
function tilted(before, direction, targets) {
  const best = nearest(targets, (ray) => Math.hypot(...cross(ballPoint(ray), direction)));
  if (at("magnet").checked && best?.gap < 0.06) {
    const { ray } = best;
    const [square, own] = [dotOf(ray, ray), dotOf(ray, before)];
    const normal = before.map((x, k) => x * square - ray[k] * own);
    return normal.some((x) => x) ? primitive(normal) : null;
  }
  const n = ballNormal(before);
  return roundedNormal(normalFrom(n.map((x, k) => x - direction[k] * dot(n, direction))));
}

function roundedNormal(v) {
  const most = Math.max(...v.map(Math.abs));
  const grid = 3 * gridSteps();
  const normal = v.map((x) => BigInt(Math.round((x * grid) / most)));
  return normal.some((x) => x) ? primitive(normal) : null;
}

// The row of a document for a plane, and back.
function rowOf(normal) {
  const [a, b, c] = state.dimension === 2 ? [normal[0], normal[1], -normal[2]] : normal;
  return [a, b, c].map((x) => ratio(x));
}

// Puts a new plane in the place of an old one; a line of the plane never goes to infinity.
function setNormal(k, normal) {
  if (!normal || (state.dimension === 2 && !normal[0] && !normal[1])) return;
  const row = rowOf(normal);
  edit(() => { state.rows = state.rows.with(k, row); });
}

// The plane that is meant by what is drawn once for several: the chosen one, else the first.
function memberOf(i) {
  const { members } = shown().arrangement;
  return members[i].includes(state.chosen) ? state.chosen : members[i][0];
}

// What a grip does: `line-2`, `end-2-0` or `circle-2`.
function gripOf(name) {
  const [kind, i, end] = name.split("-").map((part, k) => (k ? Number(part) : part));
  const { arrangement } = shown();
  const k = memberOf(i);
  const normal = arrangement.normals[k];
  return { kind, i, k, end, normal, ends: kind === "end" ? endsOf(arrangement.circles.normals[i]) : null, targets: targetsWithout(i) };
}

function movedTo(grip, place) {
  if (grip.kind === "circle") return tilted(grip.normal, place, grip.targets);
  const point = snapped(place, grip.targets);
  if (grip.kind === "line") return shifted(grip.normal, point);
  const other = grip.ends[1 - grip.end];
  const normal = through(point, other, grip.normal);
  if (normal) rememberEnds(normal, grip.end ? [other, point] : [point, other]);
  return normal;
}

function rememberEnds(normal, ends) {
  state.ends.set(unoriented(normal).join(), ends);
  if (state.ends.size > 200) state.ends.delete(state.ends.keys().next().value);
}

// The least tilt about an axis of the view that changes the rounded normal.
function tiltedBy(normal, right, up, turn) {
  const [x, y, z] = state.axes;
  const n = ballNormal(normal);
  const axis = turn ? z : x.map((value, k) => right * y[k] - up * value);
  const side = cross(axis, n);
  for (let angle = 0.7 / (3 * gridSteps()); angle < 1; angle *= 1.5) {
    const [sin, cos] = [Math.sin((turn || 1) * angle), Math.cos(angle)];
    const found = roundedNormal(normalFrom(n.map((value, k) => value * cos + side[k] * sin + axis[k] * dot(axis, n) * (1 - cos))));
    if (found && crossOf(found, normal).some((c) => c)) return found;
  }
  return null;
}

// One step with a key: along an axis of the picture, or a turn.
function stepped(grip, [right, up], turn) {
  const chart = chartOf();
  if (grip.kind === "circle") return tiltedBy(grip.normal, right, up, turn);
  const ends = grip.ends ?? endsOf(grip.normal);
  if (!ends) return null;
  const shift = (p, [a, b]) => {
    const [w, steps] = [weight(p), BigInt(gridSteps())];
    return facing(primitive(p.map((x, k) => steps * x + w * (BigInt(a) * chart.right[k] + BigInt(b) * chart.up[k]))));
  };
  if (grip.kind === "line" && !turn) return shifted(grip.normal, shift(ends[0], [right, up]));
  const end = grip.end ?? 0;
  const [a, b] = lineIn(grip.normal);
  const point = shift(ends[end], turn ? (Math.abs(b) > Math.abs(a) ? [0, turn] : [-turn, 0]) : [right, up]);
  const normal = through(point, ends[1 - end], grip.normal);
  if (normal) rememberEnds(normal, end ? [ends[1 - end], point] : [point, ends[1 - end]]);
  return normal;
}
