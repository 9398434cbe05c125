// The dual of planes: a vertex for each region, an edge for each arc, a face for each crossing. The
// place of a region is the sum of vectors along the normals with its signs.
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0],
];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = (a) => { const n = Math.hypot(...a); return a.map((x) => x / n); };

// Twice the area of a polygon on paper, positive when it goes counterclockwise.
function area(corners) {
  return corners.reduce((sum, p, i) => {
    const q = corners[(i + 1) % corners.length];
    return sum + p[0] * q[1] - p[1] * q[0];
  }, 0);
}

// The places of the regions of circles: sums of the vectors `sides` with their signs, scaled into the unit ball. And the
// faces, each with the point of the sphere that is its corner and its regions counterclockwise about `rayOf(corner, p)`,
// where p is the crossing; null leaves a face out.
function zonotopeOf({ crossings }, sides, regions, rayOf) {
  const sums = regions.map(({ key }) => [0, 1, 2].map((k) => sides.reduce((sum, v, i) => sum + (key[i] === "+" ? v[k] : -v[k]), 0)));
  const reach = Math.max(1e-9, ...sums.map((p) => Math.hypot(...p)));
  const places = new Map(regions.map(({ id }, i) => [id, sums[i].map((x) => x / reach)]));
  const number = crossings.length;
  /** @type {number[][]} */ const regionsAt = Array.from({ length: 2 * number }, () => []);
  for (const { id, corners } of regions) for (const corner of corners) regionsAt[corner].push(id);
  const faces = regionsAt.map((ids, corner) => {
    const ray = rayOf(corner, corner % number);
    return { corner, ids: ray ? around(ids.map((id) => [id, places.get(id)]), ray) : [] };
  }).filter(({ ids }) => ids.length > 2);
  return { places, faces };
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

const pairOf = (a, b) => (a < b ? `${a} ${b}` : `${b} ${a}`);

// The dual, from the back to the front. A face lists its vertices counterclockwise from outside; `place`
// gives the place of a vertex. A flat one has no far side. Returns which vertices are in front.
function paintDualOf(view, place, { faces, edges, vertices }, flat, size = 3.4) {
  view.replaceChildren();
  const near = faces.filter(({ ids }) => area(ids.map(place)) > 1e-9);
  const all = flat || !near.length || faces.length <= 2;
  const corners = new Set(near.flatMap(({ ids }) => ids));
  const sides = new Set(near.flatMap(({ ids }) => ids.map((id, k) => pairOf(id, ids[(k + 1) % ids.length]))));
  const ahead = { edge: ({ left, right }) => all || sides.has(pairOf(left, right)), vertex: ({ id }) => all || corners.has(id) };
  const layer = (front) => {
    for (const edge of edges.filter((one) => ahead.edge(one) === front)) {
      const { left, right, tint, ...attributes } = edge;
      draw("path", { class: `edge${front ? "" : " back"}`, d: `M${spot(place(left))}L${spot(place(right))}`, ...attributes }, view).style.setProperty("--tint", tint);
    }
    for (const vertex of vertices.filter((one) => ahead.vertex(one) === front)) {
      const { id, fill, style = "", ...attributes } = vertex;
      const [cx, cy] = spot(place(id)).split(",");
      const circle = draw("circle", { class: `vertex ${style}${front ? "" : " back"}`, cx, cy, r: front ? size : 0.7 * size, ...attributes }, view);
      if (fill) circle.style.fill = fill;
    }
  };
  layer(false);
  for (const { ids, ...attributes } of near) draw("path", { class: "face", d: `M${ids.map((id) => spot(place(id))).join("L")}Z`, ...attributes }, view);
  layer(true);
  return (id) => ahead.vertex({ id });
}
