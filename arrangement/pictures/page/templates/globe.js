// The sphere: arcs are curves on it, seen from far away; the rotation takes its rows as axes.
// Points along each arc of the whole arrangement.
let curves = [];

// Coordinates as given, or after the linear map that makes regions more alike. Signs stay.
const given = {
  circles: data.circles, planes: data.planes.map((plane) => plane.unit), points: data.points.map((point) => point.unit),
  arcs: data.arcs.map((arc) => arc.inside), regions: data.regions.map((region) => region.inside),
};

function setShape(even) {
  const map = (matrix) => (v) => (even && v.some(Boolean) ? unit(turned(matrix, v)) : v);
  const normals = map(data.even?.normals);
  const points = map(data.even?.points);
  data.circles = given.circles.map(normals);
  given.planes.forEach((v, k) => { data.planes[k].unit = normals(v); });
  given.points.forEach((v, k) => { data.points[k].unit = points(v); });
  given.arcs.forEach((v, k) => { data.arcs[k].inside = points(v); });
  given.regions.forEach((v, k) => { data.regions[k].inside = points(v); });
  curves = data.arcs.map(({ circle, ends }) => curveOf(data.circles[circle], ...ends.map((end) => (end < 0 ? null : data.points[end].unit))));
  return even ? data.even.axes : data.axes;
}

// A whole region; one without a boundary is the whole half.
function regionPath(region, frame, side) {
  const disk = `M${-RADIUS},0A${RADIUS} ${RADIUS} 0 0 0 ${RADIUS},0A${RADIUS} ${RADIUS} 0 0 0 ${-RADIUS},0Z`;
  if (!region.arcs.length) return disk;
  return region.pieces.map((piece) => clipped(boundaryOf(data.regions[piece].boundary, frame), side)).join("");
}

// Numbers of the planes at the limb, pushed apart.
function limbNumbers(model, axes) {
  const wanted = [];
  data.classes.forEach((members, circle) => {
    if (!model.classOn[circle]) return;
    const text = members.filter((k) => model.on[k]).map((k) => k + 1).join(",");
    const normal = turned(axes, data.circles[circle]);
    const angle = Math.atan2(normal[0], -normal[1]);
    const both = [angle, angle + Math.PI];
    const gaps = both.map((a) => Math.min(9, ...wanted.map((w) => Math.abs(turn(a - w.angle)))));
    wanted.push({ circle, text, angle: both[gaps[0] >= gaps[1] - 1e-9 ? 0 : 1] });
  });
  for (const entry of wanted) entry.shown = entry.angle;
  for (let round = 0; round < 60; round += 1) {
    for (const one of wanted) {
      for (const other of wanted) {
        const gap = turn(one.shown - other.shown);
        if (one === other || Math.abs(gap) >= 0.1) continue;
        const push = ((0.1 - Math.abs(gap)) / 2) * (gap > 0 || (gap === 0 && one.circle > other.circle) ? 1 : -1);
        one.shown += push;
        other.shown -= push;
      }
    }
  }
  return wanted;
}

const turn = (angle) => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));

// A direction inside a cell, and how far it is from the nearest boundary of a region.
function directionOf(cells, pieces) {
  const sum = [0, 1, 2].map((i) => pieces.reduce((total, k) => total + cells[k].inside[i], 0));
  return Math.hypot(...sum) < 1e-9 ? [0, 0, 1] : unit(sum);
}

function roomOf(model, region) {
  region.inside ??= directionOf(data.regions, region.pieces);
  return Math.min(1, ...region.arcs.map((id) => Math.abs(dot(data.circles[model.arcs[id].circle], region.inside))));
}

// What is under a place of the disk: a crossing, an arc, or a region. In a small region the margins
// of its arcs are small too, so that it can always be reached.
function pick(model, axes, x, y) {
  if (Math.hypot(x, y) > RADIUS) return null;
  const p = directionAt(axes, x / RADIUS, y / RADIUS);
  const signs = model.kept.map((k) => (dot(data.planes[k].unit, p) >= 0 ? "+" : "-"));
  const region = model.byKey.get(signs.join(""));
  if (region === undefined) return null;
  const room = roomOf(model, model.regions[region]);
  const near = model.regions[region].points.find((id) => {
    const ray = data.points[model.points[id].piece].unit;
    return dot(ray, p) > 0 && Math.hypot(...cross(ray, p)) < Math.min(0.045, 0.8 * room);
  });
  if (near !== undefined) return { kind: "point", id: near };
  let best = { kind: "region", id: region };
  let least = Math.min(0.022, 0.4 * room);
  for (const id of model.regions[region].arcs) {
    const distance = Math.abs(dot(data.circles[model.arcs[id].circle], p));
    if (distance < least) { least = distance; best = { kind: "arc", id }; }
  }
  return best;
}
