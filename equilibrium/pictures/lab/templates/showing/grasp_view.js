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
  const outline = state.outline ? statedOutline().map((p) => world(...p)) : outlineOf(data.contacts);
  data.outline = outline && (state.outline || !crosses(outline)) ? outline : null;
  data.stated = Boolean(state.outline);
}

// Points of the outline that the grasp states.
function statedOutline() {
  const { corners, centre, radius } = state.outline ?? { corners: [] };
  return corners ? corners.map(floatsOf)
    : Array.from({ length: 72 }, (_, k) => [near(centre[0]) + near(radius) * Math.cos((k * Math.PI) / 36), near(centre[1]) + near(radius) * Math.sin((k * Math.PI) / 36)]);
}

// Whether a closed polygon crosses itself or runs clockwise.
function crosses(points) {
  const next = (i) => points[(i + 1) % points.length];
  const side = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  if (area(points) <= 0) return true;
  return points.some((a, i) => points.slice(0, i).some((c, j) => {
    const [b, d] = [next(i), next(j)];
    return side(a, b, c) * side(a, b, d) < -1e-15 && side(c, d, a) * side(c, d, b) < -1e-15;
  }));
}

// An indicative outline: a smooth closed curve through the contacts, along their tangents.
function outlineOf(contacts) {
  const stops = contacts.filter((c, i) => contacts.findIndex((o) => Math.hypot(o.place[0] - c.place[0], o.place[1] - c.place[1]) < 1e-6) === i);
  if (!stops.length) return null;
  const convex = stops.every((a) => stops.every((b) => a.normal[0] * (b.place[0] - a.place[0]) + a.normal[1] * (b.place[1] - a.place[1]) > -1e-9));
  const along = ({ normal }) => [normal[1], -normal[0]];
  const middle = [0, 1].map((k) => stops.reduce((sum, c) => sum + c.place[k], 0) / stops.length);
  const angle = (c) => (convex ? Math.atan2(along(c)[1], along(c)[0]) : Math.atan2(c.place[1] - middle[1], c.place[0] - middle[0]));
  const steps = (c) => c.place[0] * along(c)[0] + c.place[1] * along(c)[1];
  const sorted = stops.toSorted((a, b) => (Math.abs(angle(a) - angle(b)) > 1e-9 ? angle(a) - angle(b) : steps(a) - steps(b)));
  return sorted.flatMap((a, i) => {
    const b = sorted[(i + 1) % sorted.length];
    const [u, v] = [along(a), along(b)];
    const away = [b.place[0] - a.place[0], b.place[1] - a.place[1]];
    const chord = Math.hypot(...away);
    let turn = Math.atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]);
    if (Math.abs(turn) < 1e-9 && away[0] * u[0] + away[1] * u[1] <= 1e-9) turn = 2 * Math.PI;
    if (turn < -1e-9 && convex) turn += 2 * Math.PI;
    const bulge = turn > 3.1 ? Math.max(0.6, chord * 0.36) + (turn > 5 ? 0.9 : 0) : chord * (turn < 0 ? 0.35 : 0.33 + 0.06 * turn);
    const curve = (t) => [0, 1].map((k) => (1 - t) ** 3 * a.place[k] + 3 * (1 - t) ** 2 * t * (a.place[k] + bulge * u[k])
      + 3 * (1 - t) * t * t * (b.place[k] - bulge * v[k]) + t ** 3 * b.place[k]);
    return Array.from({ length: 16 }, (_, k) => curve(k / 16));
  });
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
