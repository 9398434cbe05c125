// Lines of the projective or affine plane.

function paintPlane() {
  const view = at("plane");
  view.replaceChildren();
  const { arrangement } = shown();
  for (const region of arrangement.circles.regions) paintRegion(view, arrangement, region);
  arrangement.circles.normals.forEach((_, i) => paintLine(view, arrangement, i));
  arrangement.circles.crossings.forEach((_, p) => paintCrossing(view, arrangement, p));
  if (!player.step) arrangement.circles.normals.forEach((_, i) => paintEnds(view, arrangement, i));
}

// The part of a region that the picture shows.
function partSeen({ circles, infinity }, region) {
  let corners = cornersOf(frame(1.02));
  for (const i of new Set(region.darts.map((dart) => circles.arcs[dart >> 1].circle))) {
    const line = lineIn(circles.normals[i]);
    if (i !== infinity || line[0] || line[1]) corners = cut(corners, line.map((x) => (region.key[i] === "+" ? x : -x)), 0);
  }
  return corners;
}

function paintRegion(view, arrangement, region) {
  if (arrangement.infinity !== null && region.key[arrangement.infinity] === "-") return;
  const corners = partSeen(arrangement, region);
  if (corners.length < 3) return;
  const open = arrangement.infinity !== null && !isBounded(arrangement, region);
  draw("path", { class: `region ${styleOf(arrangement, region)}${open ? " open" : ""}`, "data-mark": regionName(arrangement, region), d: `${pathOf(corners.map(onPaper))}Z` }, view);
}

function paintLine(view, arrangement, i) {
  const { circles, infinity, members } = arrangement;
  if (i === infinity) return;
  const ends = seenPart(lineIn(circles.normals[i]), frame());
  const whole = `M-129,-109H129V109H-129Z`; // the line at infinity
  const atInfinity = !crossOf(circles.normals[i], chartOf().infinity).some((x) => x);
  if (!ends && !atInfinity) return;
  const d = atInfinity ? whole : pathOf(ends.map(onPaper));
  const group = draw("g", { class: `line grip${lineStyle(members[i])}`, "data-mark": `line-${i}`, "data-grip": `line-${i}`, tabindex: 0, role: "button",
    "aria-label": `line ${names(arrangement, i)}${atInfinity ? ", at infinity" : ""}: arrows move it, brackets turn it` }, view);
  group.style.setProperty("--tint", lineColour(arrangement, i));
  draw("path", { class: "target", d }, group);
  draw("path", { class: "stroke", d }, group);
  const [x, y] = atInfinity ? [-118, 100] : labelPlace(ends.map(onPaper));
  draw("text", { class: "number", x: fixed(x), y: fixed(y) }, group, names(arrangement, i));
}

// Beside the end that is further from the labels written so far.
/** @type {(ends: number[][]) => number[]} */
function labelPlace([p, q]) {
  const length = Math.hypot(q[0] - p[0], q[1] - p[1]) || 1;
  const [u, v] = [(q[0] - p[0]) / length, (q[1] - p[1]) / length];
  /** @type {(end: number[], way: number) => number[]} */ const beside = (end, way) => {
    const [x, y] = [end[0] + way * 7 * u - 5 * v, end[1] + way * 7 * v + 5 * u];
    return [Math.min(122, Math.max(-122, x)), Math.min(102, Math.max(-102, y))];
  };
  /** @type {(place: number[]) => number} */
  const room = ([x, y]) => Math.min(99, ...state.labels.map(([a, b]) => Math.hypot(a - x, b - y)));
  const [first, second] = [beside(p, 1), beside(q, -1)];
  const place = room(first) >= room(second) ? first : second;
  state.labels.push(place);
  return place;
}

function paintCrossing(view, { circles, infinity }, p) {
  const { ray, on } = circles.crossings[p];
  const [x, y, w] = charted(ray);
  if (Math.abs(w) < 1e-9 || (infinity !== null && !circles.crossings[p].signs[infinity])) return;
  paintMark(view, onPaper([x / w, y / w]), on.length, p);
}

// A dot; from three lines on, larger and with their number.
/** @type {(view: Element, place: number[], number: number, p: number) => void} */
function paintMark(view, [x, y], number, p) {
  const group = draw("g", { class: "crossing", "data-mark": `point-${p}` }, view);
  draw("circle", { cx: fixed(x), cy: fixed(y), r: number > 2 ? 5 : 2.4 }, group);
  if (number > 2) draw("text", { x: fixed(x), y: fixed(y) }, group, String(number));
}

// Two grips on each line: it turns about the other one.
function paintEnds(view, arrangement, i) {
  const { circles, infinity } = arrangement;
  if (i === infinity) return;
  endsOf(circles.normals[i])?.forEach((end, k) => {
    const [x, y, w] = charted(end);
    const [px, py] = onPaper([x / w, y / w]).map(fixed);
    const group = draw("g", { class: "grip end", "data-mark": `line-${i}`, "data-grip": `end-${i}-${k}`, tabindex: 0, role: "button",
      "aria-label": `end ${k + 1} of line ${names(arrangement, i)}: arrows move it` }, view);
    draw("circle", { class: "target", cx: px, cy: py, r: 9 }, group);
    draw("circle", { class: "knob", cx: px, cy: py, r: 3.4 }, group).style.setProperty("--tint", lineColour(arrangement, i));
  });
}

// The grips of a line: those it was dragged by, as long as they are on it and in sight.
/** @type {(normal: bigint[]) => bigint[][] | null} */
function endsOf(normal) {
  const { low, high } = frame(0.98);
  const kept = state.ends.get(unoriented(normal).join());
  const inSight = (end) => {
    const [x, y, w] = charted(end);
    return [x / w, y / w].every((c, k) => c > low[k] && c < high[k]);
  };
  if (kept?.every((end) => weight(end) && inSight(end))) return kept;
  const part = seenPart(lineIn(normal), frame(0.9));
  if (!part) return null;
  const ends = [0, 1].map((end) => apart(normal, part[end], part[1 - end]));
  if (!ends.every((end) => weight(end)) || !crossOf(ends[0], ends[1]).some((x) => x)) return null;
  rememberEnds(normal, ends);
  return ends;
}

// An exact point of a line near the end of what is seen, away from crossings and other grips.
/** @type {(normal: bigint[], from: number[], to: number[]) => bigint[]} */
function apart(normal, from, to) {
  const { crossings, normals } = shown().arrangement.circles;
  const others = normals.flatMap((n) => state.ends.get(unoriented(n).join()) ?? []);
  const own = [...crossings.map(({ ray }) => ray), ...others].map(charted).map(([x, y, w]) => [x / w, y / w]);
  const found = [0.05, 0.09, 0.13, 0.17, 0.21, 0.25, 0.29].map((share) => {
    const end = onLine(normal, [0, 1].map((k) => from[k] + share * (to[k] - from[k])));
    const [x, y, w] = charted(end);
    return { end, room: Math.min(12 / scale(), ...own.map(([a, b]) => Math.hypot(a - x / w, b - y / w))) };
  });
  return found.reduce((best, one) => (one.room > best.room ? one : best)).end;
}

// The ball, with grips, and with its crossings as the plane has them.
function paintBall() {
  const view = at("ball");
  const { arrangement } = shown();
  const { circles, infinity, members } = arrangement;
  paintGlobe(view, (i) => {
    if (i === infinity) return { class: "line grip infinity", "data-mark": `line-${i}` };
    return { class: `line grip${lineStyle(members[i])}`, "data-mark": `line-${i}`, "data-grip": `circle-${i}`, tabindex: 0, role: "button",
      "aria-label": `great circle ${names(arrangement, i)}: arrows tilt it` };
  });
  circles.crossings.forEach(({ ray, on }, p) => {
    const point = turned(state.axes, ballPoint(ray));
    for (const way of [1, -1]) if (way * point[2] > 1e-9) paintMark(view, [way * RADIUS * point[0], -way * RADIUS * point[1]], on.length, p);
  });
}
