// The grasp: outline, cones, preloads; for the chosen states also marks, forces and motion.
// How far the drawing reaches; names and preloads stand outside of the contacts.
const REACH = Math.max(1, ...[...(data.outline ?? []), data.origin].flat().map((x) => Math.abs(x) + 0.15),
  ...data.contacts.flatMap(({ place: p, normal: n }) => [0, 1].map((k) => Math.abs(p[k] - 0.7 * n[k]))));
const UNIT = Math.min(72, 114 / REACH);
const spot = (p) => `${fixed(UNIT * p[0])},${fixed(-UNIT * p[1])}`;
const along = (p, v, s) => [p[0] + s * v[0], p[1] + s * v[1]];

function arrow(view, from, to, style, width = 1) {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(dx, dy);
  if (length < 1e-6) return;
  const [ux, uy] = [dx / length, dy / length];
  const head = Math.min(0.13 * width, 0.6 * length);
  const side = 0.018 * width;
  const corner = (s, t) => [to[0] - s * ux - t * uy, to[1] - s * uy + t * ux];
  const corners = [corner(length, side), corner(head, side), corner(head, 0.42 * head), to,
    corner(head, -0.42 * head), corner(head, -side), corner(length, -side)];
  draw("path", { class: style, d: `M${corners.map(spot).join("L")}Z` }, view);
}

function paintGrasp() {
  const view = at("grasp");
  view.replaceChildren();
  const piece = state.found[state.choice];
  const point = wrenchPoint();
  const motion = piece?.motion && point ? piece.motion.map((row) => near(valueOf(row, point))) : null;
  const forces = piece && point
    ? forcesOf(piece).map((pair) => pair.map((row) => row && near(valueOf(row, point)))) : null;
  if (data.outline) {
    draw("path", { class: data.stated ? "body stated" : "body", d: `M${data.outline.map(spot).join("L")}Z` }, view);
    if (motion) paintMotion(view, motion);
  }
  const longest = Math.max(1e-12, ...data.contacts.map((c) => c.preload));
  data.contacts.forEach((contact, i) => {
    const { place, normal: n } = contact;
    const t = [-n[1], n[0]];
    draw("path", { class: "cone", d: `M${spot(place)}L${contact.cone.map(spot).join("L")}Z` }, view);
    draw("path", { class: "middle", d: `M${spot(place)}L${spot(contact.cone[4])}` }, view);
    draw("path", { class: "pad", d: `M${spot(along(place, t, 0.08))}L${spot(along(place, t, -0.08))}` }, view);
    const preload = state.kind === "own" ? contact.preload / longest : 1;
    if (state.factor.n > 0n && preload > 0) {
      arrow(view, along(place, n, -0.22 - 0.2 * preload), along(place, n, -0.19), "preload", 1.6);
    }
    if (piece) mark(view, piece.states[i], along(place, n, -0.085), t);
  });
  paintLoads(view, forces);
  data.contacts.forEach(({ place, normal }, i) => {
    const twins = data.contacts.slice(0, i).filter((c) => c.place[0] === place[0] && c.place[1] === place[1]).length;
    const [x, y] = along(along(place, normal, -0.6), [-normal[1], normal[0]], 0.16 * twins);
    draw("text", { class: "name", x: fixed(UNIT * x), y: fixed(-UNIT * y) }, view, String(i + 1));
  });
}

// The displaced outline to first order, with a motion that is made large enough to be seen.
function paintMotion(view, [x, y, r]) {
  const moved = data.outline.map((p) => {
    const [u, v] = [0, 1].map((k) => p[k] * data.size + data.centre[k]);
    return [(x - r * v) / data.size, (y + r * u) / data.size];
  });
  const most = Math.max(...moved.map((p) => Math.hypot(...p)));
  if (most < 1e-12) return;
  const places = data.outline.map((p, i) => along(p, moved[i], 0.22 / most));
  draw("path", { class: "moved", d: `M${places.map(spot).join("L")}Z` }, view);
}

function mark(view, what, place, t) {
  const way = what === "slip-" ? -1 : 1;
  if (what === "stick" || what === "detached") {
    draw("circle", { class: `state ${what}`, cx: fixed(UNIT * place[0]), cy: fixed(-UNIT * place[1]), r: 4 }, view);
    return;
  }
  const n = [t[1], -t[0]];
  const corners = [along(place, t, 0.11 * way), along(along(place, t, -0.06 * way), n, 0.075),
    along(along(place, t, -0.06 * way), n, -0.075)];
  draw("path", { class: "state slip", d: `M${corners.map(spot).join("L")}Z` }, view);
}

function paintLoads(view, forces) {
  const force = shownForce();
  const load = force ? force.map(near) : [0, 0];
  const sizes = [Math.hypot(...load), ...(forces ?? []).map(([c, s]) => (s === null || c === null ? 0 : Math.hypot(c, s)))];
  const factor = 0.85 / Math.max(1e-12, ...sizes);
  if (forces) {
    data.contacts.forEach(({ place, normal: n }, i) => {
      const [c, s] = forces[i];
      if (c === null || s === null) return;
      arrow(view, place, along(along(place, n, c * factor), [-n[1], n[0]], s * factor), "force");
    });
  }
  const origin = data.origin;
  arrow(view, origin, along(origin, load, factor), "load", 1.4);
  draw("path", { class: "axis", d: `M${spot(along(origin, [1, 0], -0.05))}L${spot(along(origin, [1, 0], 0.05))}M${spot(along(origin, [0, 1], -0.05))}L${spot(along(origin, [0, 1], 0.05))}` }, view);
  if (force && state.torque.n) paintTwist(view, origin, state.torque.n > 0n ? 1 : -1);
}

function paintTwist(view, origin, way) {
  const at30 = (k) => [origin[0] + 0.26 * Math.cos((way * k * Math.PI) / 12), origin[1] + 0.26 * Math.sin((way * k * Math.PI) / 12)];
  draw("path", { class: "twist", d: `M${Array.from({ length: 17 }, (_, k) => spot(at30(k + 2))).join("L")}` }, view);
  const tip = at30(18);
  const direction = [-(tip[1] - origin[1]) * way, (tip[0] - origin[0]) * way];
  arrow(view, along(tip, direction, -0.02), along(tip, direction, 0.42), "load", 1.2);
}
