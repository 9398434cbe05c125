// The ball with its great circles, seen from far away, and the dual that turns with it.

const rayOf = ({ crossings }, p) => {
  const ray = ballPoint(crossings[p % crossings.length].ray);
  return p < crossings.length ? ray : ray.map((x) => -x);
};

// Points along an arc, both ends included; whole circles where nothing crosses.
function curveOf(normal, start, stop) {
  const angle = stop ? Math.atan2(Math.hypot(...cross(start, stop)), dot(start, stop)) : 2 * Math.PI;
  const side = cross(normal, start);
  const pieces = Math.max(1, Math.ceil(angle / 0.07));
  return Array.from({ length: pieces + 1 }, (_, k) => {
    const a = (angle * k) / pieces;
    return start.map((x, j) => Math.cos(a) * x + Math.sin(a) * side[j]);
  });
}

// The curves of an arrangement, once; turning only turns them.
function curvesOf({ circles }) {
  if (circles.curves?.shape !== state.shape) {
    const list = circles.arcs.map(({ circle, from, to }) => curveOf(ballNormal(circles.normals[circle]), rayOf(circles, from), rayOf(circles, to)));
    circles.curves = { shape: state.shape, list };
  }
  return circles.curves.list;
}

function paintBall() {
  const view = at("ball");
  view.replaceChildren();
  const { arrangement } = shown();
  const { circles, infinity, members } = arrangement;
  const turn = (p) => turned(state.axes, p);
  const curves = curvesOf(arrangement).map((curve) => curve.map(turn));
  draw("circle", { class: "disc", r: RADIUS }, view);
  for (const region of circles.regions) paintBallRegion(view, arrangement, region, curves);
  const lone = circles.normals.length === 1 ? [loneCurve(circles.normals[0]).map(turn)] : null;
  circles.normals.forEach((_, i) => {
    const own = lone ?? curves.filter((__, e) => circles.arcs[e].circle === i);
    const grip = i === infinity ? {} : { "data-grip": `circle-${i}`, tabindex: 0, role: "button", "aria-label": `great circle ${names(members[i])}: arrows tilt it` };
    const group = draw("g", { class: `line grip${i === infinity ? " infinity" : lineStyle(members[i])}`, "data-mark": `line-${i}`, ...grip }, view);
    group.style.stroke = lineColour(i === infinity ? null : i);
    draw("path", { class: "hidden-part", d: own.map((curve) => visible(curve, -1)).join("") || "M0,0" }, group);
    const d = own.map((curve) => visible(curve, 1)).join("") || "M0,0";
    draw("path", { class: "target", d }, group);
    draw("path", { class: "stroke", d }, group);
  });
  draw("circle", { class: "rim-line", r: RADIUS }, view);
  circles.crossings.forEach(({ on }, p) => {
    const ray = turn(rayOf(circles, p));
    for (const way of [1, -1]) if (way * ray[2] > 1e-9) paintMark(view, [way * RADIUS * ray[0], -way * RADIUS * ray[1]], on.length, p);
  });
}

const loneCurve = (normal) => {
  const n = ballNormal(normal);
  return curveOf(n, unit(Math.abs(n[2]) < 0.9 ? cross(n, [0, 0, 1]) : cross(n, [1, 0, 0])), null);
};

function paintBallRegion(view, arrangement, region, curves) {
  const boundary = region.darts.flatMap((dart) => (dart & 1 ? [...curves[dart >> 1]].reverse() : curves[dart >> 1]).slice(0, -1));
  const d = region.darts.length ? clipped(boundary, 1) : "";
  if (!d) return;
  const beyond = arrangement.infinity !== null && region.key[arrangement.infinity] === "-";
  const path = draw("path", { class: `region${beyond ? " beyond" : ""}`, d, ...(beyond ? {} : { "data-mark": regionName(arrangement, region) }) }, view);
  if (!beyond) path.style.fill = colourOf(arrangement, region);
}

// The dual: a region is the sum of the normals with its signs. In space this is the zonotope; for
// lines of the affine plane it is a tiling of a polygon by smaller ones.
function dualOf(arrangement) {
  const { circles, infinity } = arrangement;
  if (circles.dual?.shape === state.shape) return circles.dual;
  const { arcs, regions, points } = facesOf(arrangement);
  const sides = circles.normals.map((n, i) => (i === infinity ? [0, 0, 0] : infinity === null ? ballNormal(n) : unit([...floats(n).slice(0, 2), 0])));
  const places = new Map(regions.map(({ id, key }) => [id, [0, 1, 2].map((k) => sides.reduce((sum, v, i) => sum + (key[i] === "+" ? v[k] : -v[k]), 0))]));
  const reach = Math.max(1, ...[...places.values()].map((p) => Math.hypot(...p)));
  for (const [id, p] of places) places.set(id, p.map((x) => x / reach));
  const number = circles.crossings.length;
  const faces = [...circles.crossings.keys(), ...circles.crossings.keys()].map((p, k) => {
    const corner = k < number ? p : p + number;
    const ids = regions.filter(({ corners }) => corners?.includes(corner)).map(({ id }) => id);
    return { p, normal: infinity === null ? rayOf(circles, corner) : [0, 0, 1], ids: infinity === null || circles.crossings[p].signs[infinity] ? around(ids.map((id) => [id, places.get(id)]), infinity === null ? rayOf(circles, corner) : [0, 0, 1]) : [] };
  }).filter(({ ids }) => ids.length > 2);
  const edges = arcs.length || circles.normals.length !== 1 || infinity !== null ? arcs : [{ circle: 0, left: 0, right: 1 }];
  circles.dual = { shape: state.shape, regions, places, faces, edges, points };
  return circles.dual;
}

// The corners of a face in their order about its normal.
function around(corners, normal) {
  if (!corners.length) return [];
  const middle = [0, 1, 2].map((k) => corners.reduce((sum, [, p]) => sum + p[k], 0) / corners.length);
  const u = unit(corners[0][1].map((x, k) => x - middle[k]));
  const v = cross(normal, u);
  const angle = (p) => Math.atan2(dot(v, p), dot(u, p));
  return corners.map(([id, p]) => [id, angle(p.map((x, k) => x - middle[k]))]).sort((a, b) => a[1] - b[1]).map(([id]) => id);
}

function paintDual() {
  const view = at("dual");
  view.replaceChildren();
  const { arrangement } = shown();
  const { regions, places, faces, edges } = dualOf(arrangement);
  const flat = arrangement.infinity !== null;
  const turn = (p) => (flat ? p : turned(state.axes, p));
  const at2 = new Map([...places].map(([id, p]) => [id, turn(p)]));
  const front = faces.filter(({ normal }) => flat || turn(normal)[2] > 1e-9);
  const seen = new Set(front.flatMap(({ ids }) => ids));
  const solid = faces.length > 0 && !flat;
  const line = ({ circle, left, right }, style) => {
    const path = draw("path", { class: style, "data-mark": `line-${circle}`, d: pathOf([left, right].map((id) => paper(at2.get(id)))) }, view);
    path.style.stroke = lineColour(circle);
  };
  const paper = ([x, y]) => [RADIUS * x, -RADIUS * y];
  const isSeen = (edge) => !solid || front.some(({ ids }) => ids.includes(edge.left) && ids.includes(edge.right));
  for (const edge of edges) if (!isSeen(edge)) line(edge, "edge back");
  for (const { p, ids } of front) draw("path", { class: "face", "data-mark": `point-${p}`, d: `${pathOf(ids.map((id) => paper(at2.get(id))))}Z` }, view);
  for (const edge of edges) if (isSeen(edge)) line(edge, "edge");
  for (const region of regions) {
    if (solid && !seen.has(region.id)) continue;
    const [x, y] = paper(at2.get(region.id)).map(fixed);
    draw("circle", { class: "corner", "data-mark": regionName(arrangement, region), cx: x, cy: y, r: 3.4 }, view).style.fill = colourOf(arrangement, region);
  }
}
