// The grasp: object, contacts, load, forces of an equilibrium, and the chosen motion.
const world = (x, y) => [(x - data.centre[0]) / data.size, (y - data.centre[1]) / data.size];
const atPaper = (point) => world(...point.map(near));
const floatsOf = (pair) => pair.map(near);

// The frame in which contacts, their grips and the outline fill the picture, and what `sketch.js` draws in it. While
// something is dragged the frame stays.
function frameGrasp() {
  if (!dragging()) {
    Object.assign(data, { centre: [0, 0], size: 1 });
    for (const places of [state.grasp.map(({ point }) => floatsOf(point)), null]) {
      const points = places ? [...places, ...statedOutline()] : [...data.contacts.flatMap((c) => [c.place, along(c.place, c.normal, 0.6)]), ...(data.outline ?? [])].map((p) => p.map((x, k) => x * data.size + data.centre[k]));
      const span = [0, 1].map((k) => points.map((p) => p[k])).map((v) => (v.length ? [Math.min(...v), Math.max(...v)] : [-1, 1]));
      data.centre = span.map(([low, high]) => (low + high) / 2);
      data.size = Math.max(...span.map(([low, high], k) => (high - low) / [2, 2.3][k])) || 1;
      placeGrasp();
    }
    // Names stand outside of contacts, above and below too.
    data.size *= Math.max(1, ...data.contacts.map(({ place: [, y], normal: [, n] }) => (y * n < 0 ? Math.abs(y) / (1.5 - 0.66 * Math.abs(n)) : 0)));
  }
  placeGrasp();
}

function placeGrasp() {
  data.contacts = state.grasp.map((contact) => {
    const [p, n] = [atPaper(contact.point), floatsOf(contact.normal)];
    const half = Math.atan(near(contact.friction));
    const edge = (a) => along(along(p, n, 0.55 * Math.cos(a)), [-n[1], n[0]], 0.55 * Math.sin(a));
    return { place: p, normal: n, cone: Array.from({ length: 9 }, (_, k) => edge((k / 4 - 1) * half)) };
  });
  data.origin = world(0, 0).map((x) => Math.min(1.5, Math.max(-1.5, x)));
  data.outline = (state.outline ? statedOutline() : outlineOf(state.grasp))?.map((p) => world(...p)) ?? null;
  data.stated = Boolean(state.outline);
}

// Points of the outline that the grasp states.
function statedOutline() {
  const { corners, centre, radius } = state.outline ?? { corners: [] };
  return corners ? corners.map(floatsOf)
    : Array.from({ length: 72 }, (_, k) => [near(centre[0]) + near(radius) * Math.cos((k * Math.PI) / 36), near(centre[1]) + near(radius) * Math.sin((k * Math.PI) / 36)]);
}

// An indicative outline, that of the still pictures: a smooth closed curve through the contacts, along their tangents;
// null where it would cross itself. Lengths are in halves of the larger extent of the contacts.
function outlineOf(grasp) {
  const places = grasp.map(({ point }) => floatsOf(point));
  if (!places.length) return null;
  const span = [0, 1].map((k) => places.map((p) => p[k])).map((v) => [Math.min(...v), Math.max(...v)]);
  const middle = span.map(([low, high]) => (low + high) / 2);
  const half = Math.max(...span.map(([low, high]) => (high - low) / 2)) || 1;
  const all = grasp.map(({ normal }, i) => {
    const n = floatsOf(normal);
    return { p: places[i].map((x, k) => (x - middle[k]) / half), n, u: [n[1], -n[0]] };
  });
  const stops = all.filter((a, i) => all.findIndex((b) => same2(a.p, b.p) && same2(a.n, b.n)) === i);
  const convex = stops.every((a) => stops.every((b) => dot2(a.n, b.p.map((x, k) => x - a.p[k])) > -1e-9));
  const mean = [0, 1].map((k) => stops.reduce((sum, { p }) => sum + p[k], 0) / stops.length);
  const pieces = convex ? convexPieces(stops)
    : [mean, middle.map((x) => -x / half)].filter((c) => Math.max(...c.map(Math.abs)) <= 2).map((c) => piecesAround(stops, c)).find(Boolean);
  return pieces ? pieces.flatMap((piece) => flattened(piece, 16)).map((p) => p.map((x, k) => x * half + middle[k])) : null;
}

const dot2 = (a, b) => a[0] * b[0] + a[1] * b[1];
const same2 = (a, b) => a[0] === b[0] && a[1] === b[1];
const angleOf = ([x, y]) => (Math.atan2(y, x) + 2 * Math.PI) % (2 * Math.PI);
const spun = ([x, y], a) => [x * Math.cos(a) - y * Math.sin(a), x * Math.sin(a) + y * Math.cos(a)];
const flattened = ([p, q, r, end], steps) => Array.from({ length: steps }, (_, k) => k / steps)
  .map((t) => [0, 1].map((i) => (1 - t) ** 3 * p[i] + 3 * t * (1 - t) ** 2 * q[i] + 3 * t * t * (1 - t) * r[i] + t ** 3 * end[i]));
const cyclic = (list) => list.map((a, i) => [a, list[(i + 1) % list.length]]);
const inOrder = (stops, ...keys) => stops.toSorted((a, b) => {
  for (const key of keys) if (Math.abs(key(a) - key(b)) > 1e-9) return key(a) - key(b);
  return 0;
});

// Contacts in the order of their tangent directions, counter-clockwise.
function convexPieces(stops) {
  return cyclic(inOrder(stops, ({ u }) => angleOf(u), ({ p, u }) => dot2(p, u))).flatMap(([a, b]) => {
    let turn = (angleOf(b.u) - angleOf(a.u) + 2 * Math.PI) % (2 * Math.PI);
    if (Math.min(turn, 2 * Math.PI - turn) < 1e-9) turn = dot2(b.p.map((x, k) => x - a.p[k]), a.u) <= 0 ? 2 * Math.PI : 0;
    const chain = [a, ...(turn > Math.PI - 1e-9 ? between(a, b, turn) : []), b];
    return chain.slice(1).map((stop, i) => bend(chain[i], stop));
  });
}

// Further stops where the outline turns by half a turn or more: of a circle that touches the tangents of both ends.
function between({ p, u }, { p: q }, turn) {
  const middle = [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
  const reach = Math.max(Math.hypot(q[0] - p[0], q[1] - p[1]), 1) / 2;
  const half = spun(u, turn / 2);
  const outward = [half[1], -half[0]];
  if (turn < 1.15 * Math.PI) return [{ p: along(middle, outward, reach), u: half }];
  const n = [-u[1], u[0]];
  const centre = along(middle, outward, (reach - dot2(n, [middle[0] - p[0], middle[1] - p[1]])) / dot2(n, outward));
  const number = Math.ceil(turn / (0.5 * Math.PI) - 1e-9) - 1;
  return Array.from({ length: number }, (_, j) => spun(u, (turn * (j + 1)) / (number + 1)))
    .map((w) => ({ p: along(centre, [w[1], -w[0]], reach), u: w }));
}

// A cubic from one stop to the next, that of a circle where one fits.
function bend({ p, u }, { p: q, u: v }) {
  const away = [q[0] - p[0], q[1] - p[1]];
  const chord = Math.hypot(...away);
  const sine = u[0] * v[1] - u[1] * v[0];
  const turn = Math.abs(Math.atan2(sine, dot2(u, v)));
  const share = (4 / 3) * (Math.tan(turn / 4) / Math.tan(turn / 2));
  const arms = turn < 1e-9 || Math.abs(sine) < 1e-9 ? [chord / 3, chord / 3]
    : [away[0] * v[1] - away[1] * v[0], u[0] * away[1] - u[1] * away[0]].map((x) => Math.min(Math.max((share * x) / sine, 0), 0.9 * chord));
  return [p, along(p, u, arms[0]), along(q, v, -arms[1]), q];
}

// Contacts in angular order around a centre; null when the curve crosses itself.
function piecesAround(stops, centre) {
  const from = ({ p }) => angleOf([p[0] - centre[0], p[1] - centre[1]]);
  const pieces = cyclic(inOrder(stops, from, ({ u }) => angleOf(u))).map(([{ p, u }, { p: q, u: v }]) => {
    const arm = 0.38 * Math.hypot(q[0] - p[0], q[1] - p[1]);
    return [p, along(p, u, arm), along(q, v, -arm), q];
  });
  return stops.length < 3 || crosses(pieces.flatMap((piece) => flattened(piece, 12))) ? null : pieces;
}

// Whether a closed polygon crosses itself or runs clockwise.
function crosses(points) {
  if (area(points) <= 0) return true;
  const side = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  const edges = cyclic(points);
  const apart = ([a, b], [c, d]) => side(a, b, c) * side(a, b, d) < -1e-18;
  return edges.some((one, i) => edges.slice(0, i).some((other) => apart(one, other) && apart(other, one)));
}

// How long a force is drawn; while something is dragged lengths stay comparable.
function forceScale(forces) {
  const sizes = [Math.hypot(...floatsOf(state.wrench.slice(0, 2))), ...forces.map((pair) => Math.hypot(...pair))];
  if (!dragging() || !state.scale) state.scale = 0.85 / (Math.max(...sizes) || 1);
  return state.scale;
}

const torqueUnit = () => {
  const least = Math.abs(near(state.wrench[2])) / data.size / 5.5;
  return data.size * (least > 1 ? 2 ** Math.ceil(Math.log2(least)) : 1);
};

function paintGrasp() {
  frameGrasp();
  const view = at("grasp");
  const held = /** @type {HTMLElement} */ (document.activeElement)?.dataset?.grip;
  view.replaceChildren();
  if (at("regions").checked) paintRegions(draw("g", {}, view));
  if (data.outline) paintBody(view);
  const shown = state.shownMotion();
  if (shown) paintGhost(draw("g", { class: "ghost" }, view), shown.motion.map(near), shown.virtual);
  const piece = state.shownPiece();
  const forces = piece ? piece.forces.map(floatsOf) : [];
  const factor = forceScale(forces);
  state.grasp.forEach((contact, i) => paintOne(view, contact, i, shown, piece));
  forces.forEach(([c, s], i) => {
    const { place: p, normal: n } = data.contacts[i];
    if (c || s) arrow(view, p, along(along(p, n, c * factor), [-n[1], n[0]], s * factor), "force");
  });
  paintLoad(view, factor);
  paintNames(view);
  // A grip that is dragged takes the focus again when it is let go.
  const focus = dragging() ? null : state.focus ?? held;
  if (focus) { state.focus = null; view.querySelector(`[data-grip="${focus}"]`)?.focus(); }
  at("grasp-caption").textContent = shown ? shown.words : data.stated ? "The object as the grasp states it. Orange: friction cones and the load." : data.outline
    ? "Dashed: an outline that fits the contacts, only indicative. Orange: friction cones and the load."
    : state.grasp.length ? "Orange: friction cones and the load." : "No contact yet: add one below.";
}

function paintOne(view, contact, i, shown, piece) {
  const group = draw("g", { "data-contact": i, class: "contact" }, view);
  const { place: p, normal: n } = data.contacts[i];
  const t = [-n[1], n[0]];
  const loaded = contact.preload.n > 0n;
  const zigzag = Array.from({ length: 9 }, (_, k) => along(along(p, n, -0.25 - 0.022 * k), t, k % 2 ? 0.045 : -0.045));
  draw("path", { class: `spring${loaded ? " loaded" : ""}`, d: `M${[along(p, n, -0.2), ...zigzag, along(p, n, -0.48)].map(sketched).join("L")}` }, group);
  paintContact(group, data.contacts[i]);
  const states = shown && !shown.virtual ? shown.states : piece?.states;
  if (states) paintState(group, states[i], along(p, n, -0.15), t);
  const words = `contact ${i + 1} at ${tuple(contact.point.map(textOf))}, normal ${tuple(contact.normal.map(textOf))}`;
  grip(group, `move-${i}`, p, `${words}; arrows move it`, state.chosen === i ? "chosen" : "", 3.2);
  grip(group, `turn-${i}`, along(p, n, 0.6), `normal of ${words}; arrows turn it`, "turn-grip", 2.4);
}

function grip(parent, name, p, label, style, radius) {
  const group = draw("g", { class: `grip ${style}`, tabindex: 0, role: "button", "data-grip": name, "aria-label": label }, parent);
  const middle = { cx: fixed(UNIT * p[0]), cy: fixed(-UNIT * p[1]) };
  draw("circle", { class: "target", ...middle, r: 11 }, group);
  draw("circle", { class: "knob", ...middle, r: radius }, group);
}

function paintLoad(view, factor) {
  const { origin } = data;
  const load = floatsOf(state.wrench.slice(0, 2));
  const tip = along(origin, load, factor);
  arrow(view, origin, tip, "load", 1.4);
  paintOrigin(view);
  const turn = (near(state.wrench[2]) / torqueUnit()) * (Math.PI / 4);
  const round = (a) => [origin[0] + 0.3 * Math.cos(a), origin[1] + 0.3 * Math.sin(a)];
  draw("circle", { class: "dial", cx: fixed(UNIT * origin[0]), cy: fixed(-UNIT * origin[1]), r: 0.3 * UNIT }, view);
  if (turn) draw("path", { class: "twist", d: `M${Array.from({ length: 33 }, (_, k) => sketched(round((turn * k) / 32))).join("L")}` }, view);
  const words = tuple(state.wrench.map(textOf));
  grip(view, "load", tip, `load ${words}; arrows change the force`, "load-grip", 3.2);
  grip(view, "torque", round(turn), `torque ${textOf(state.wrench[2])}; arrows change it`, "load-grip", 2.4);
}

// The displaced outline to first order, the displacement of each contact, and the centre.
function paintGhost(view, [x, y, r], virtual) {
  const shift = (p) => {
    const [u, v] = [0, 1].map((k) => p[k] * data.size + data.centre[k]);
    return [(x - r * v) / data.size, (y + r * u) / data.size];
  };
  const places = [...(data.outline ?? []), ...data.contacts.map((c) => c.place)];
  const most = Math.max(1e-12, ...places.map((p) => Math.hypot(...shift(p))));
  const factor = 0.26 / most;
  if (data.outline) draw("path", { class: "moved", d: `M${data.outline.map((p) => sketched(along(p, shift(p), factor))).join("L")}Z` }, view);
  for (const { place: p } of data.contacts) arrow(view, p, along(p, shift(p), factor * (virtual ? 1.4 : 1)), "load", 0.9);
  if (!r) return;
  const centre = world(-y / r, x / r);
  if (Math.max(...centre.map(Math.abs)) > 2.1) return;
  draw("circle", { class: "centre", cx: fixed(UNIT * centre[0]), cy: fixed(-UNIT * centre[1]), r: 2.6 }, view);
  paintTwist(view, centre, Math.sign(r));
}
