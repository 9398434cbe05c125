// What every drawing of a grasp has: outline, contacts with cones, numbers, origin, arrows.
// How far the drawing reaches; names and preloads stand outside of the contacts.
const REACH = Math.max(1, ...[...(data.outline ?? []), data.origin].flat().map((x) => Math.abs(x) + 0.15),
  ...data.contacts.flatMap(({ place: p, normal: n }) => [0, 1].map((k) => Math.abs(p[k] - 0.7 * n[k]))));
const UNIT = Math.min(72, 114 / REACH);
// The text of a place of the drawing.
const sketched = (p) => `${fixed(UNIT * p[0])},${fixed(-UNIT * p[1])}`;
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
  draw("path", { class: style, d: `M${corners.map(sketched).join("L")}Z` }, view);
}

function paintBody(view) {
  draw("path", { class: data.stated ? "body stated" : "body", d: `M${data.outline.map(sketched).join("L")}Z` }, view);
}

function paintContact(view, { place, normal: n, cone }) {
  const t = [-n[1], n[0]];
  draw("path", { class: "cone", d: `M${sketched(place)}L${cone.map(sketched).join("L")}Z` }, view);
  draw("path", { class: "middle", d: `M${sketched(place)}L${sketched(cone[(cone.length - 1) / 2])}` }, view);
  draw("path", { class: "pad", d: `M${sketched(along(place, t, 0.08))}L${sketched(along(place, t, -0.08))}` }, view);
}

function paintNames(view) {
  data.contacts.forEach(({ place, normal }, i) => {
    const twins = data.contacts.slice(0, i).filter((c) => c.place[0] === place[0] && c.place[1] === place[1]).length;
    const [x, y] = along(along(place, normal, -0.6), [-normal[1], normal[0]], 0.16 * twins);
    draw("text", { class: "name", x: fixed(UNIT * x), y: fixed(-UNIT * y) }, view, String(i + 1));
  });
}

function paintOrigin(view) {
  const { origin } = data;
  draw("path", { class: "axis", d: `M${sketched(along(origin, [1, 0], -0.05))}L${sketched(along(origin, [1, 0], 0.05))}M${sketched(along(origin, [0, 1], -0.05))}L${sketched(along(origin, [0, 1], 0.05))}` }, view);
}

function paintTwist(view, origin, way) {
  const at30 = (k) => [origin[0] + 0.26 * Math.cos((way * k * Math.PI) / 12), origin[1] + 0.26 * Math.sin((way * k * Math.PI) / 12)];
  draw("path", { class: "twist", d: `M${Array.from({ length: 17 }, (_, k) => sketched(at30(k + 2))).join("L")}` }, view);
  const tip = at30(18);
  const direction = [-(tip[1] - origin[1]) * way, (tip[0] - origin[0]) * way];
  arrow(view, along(tip, direction, -0.02), along(tip, direction, 0.42), "load", 1.2);
}

// The state of a contact: a disc (stick), a ring (detached), or an arrow head along the slip.
function paintState(view, what, place, t) {
  const way = what === "slip-" ? -1 : 1;
  if (what === "stick" || what === "detached") {
    draw("circle", { class: `state ${what}`, cx: fixed(UNIT * place[0]), cy: fixed(-UNIT * place[1]), r: 4 }, view);
    return;
  }
  const n = [t[1], -t[0]];
  const corners = [along(place, t, 0.11 * way), along(along(place, t, -0.06 * way), n, 0.075),
    along(along(place, t, -0.06 * way), n, -0.075)];
  draw("path", { class: "state slip", d: `M${corners.map(sketched).join("L")}Z` }, view);
}
