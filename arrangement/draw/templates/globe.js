// The sphere: arcs are curves on it, seen from far away; the rotation takes its rows as axes.
const RADIUS = 100;
const STEP = Math.PI / 60;
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0],
];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = (a) => { const n = Math.hypot(...a); return a.map((x) => x / n); };
const turned = (axes, p) => axes.map((axis) => dot(axis, p));
const fixed = (x) => (Math.round(x * 10) / 10).toString();
const spot = (p) => `${fixed(RADIUS * p[0])},${fixed(-RADIUS * p[1])}`;

// Points along each arc of the whole arrangement, both ends included.
const curves = data.arcs.map((arc) => {
  const normal = data.circles[arc.circle];
  const [start, stop] = arc.ends.map((end) => (end < 0 ? null : data.points[end].unit));
  const p = start ?? unit(Math.abs(normal[2]) < 0.9 ? cross(normal, [0, 0, 1]) : cross(normal, [1, 0, 0]));
  let angle = 2 * Math.PI;
  if (start) angle = Math.atan2(Math.hypot(...cross(p, stop)), dot(p, stop));
  const side = cross(normal, p);
  const pieces = Math.max(1, Math.ceil(angle / STEP));
  return Array.from({ length: pieces + 1 }, (_, i) => {
    const a = (angle * i) / pieces;
    return p.map((x, j) => Math.cos(a) * x + Math.sin(a) * side[j]);
  });
});

// Where the way from a visible point to a hidden one leaves the visible half.
function onLimb(p, q) {
  const s = p[2] / (p[2] - q[2]);
  const x = p[0] + s * (q[0] - p[0]);
  const y = p[1] + s * (q[1] - p[1]);
  const n = Math.hypot(x, y) || 1;
  return [x / n, y / n, 0];
}

// The part of a curve on the half with side * z >= 0, as path text.
function visible(curve, side) {
  let text = "";
  let drawing = false;
  curve.forEach((p, i) => {
    const here = side * p[2] >= -1e-9;
    if (i > 0) {
      const before = side * curve[i - 1][2] >= -1e-9;
      if (here !== before) {
        text += `${drawing ? "L" : "M"}${spot(onLimb(curve[i - 1], p))}`;
        drawing = here;
      }
    }
    if (here) {
      text += `${drawing ? "L" : "M"}${spot(p)}`;
      drawing = true;
    }
  });
  return text;
}

// The boundary of a piece as one closed curve of points.
function boundary(piece, frame) {
  return data.regions[piece].boundary.flatMap((half) => {
    const curve = frame[half >> 1];
    return half & 1 ? [...curve].reverse().slice(0, -1) : curve.slice(0, -1);
  });
}

// The part of a piece on the half with side * z >= 0, as path text. Along the limb the way always
// goes counterclockwise about that half.
function clipped(curve, side) {
  const inside = curve.map((p) => side * p[2] >= -1e-9);
  const n = curve.length;
  if (inside.every(Boolean)) return side * area(curve) > 0 ? `M${curve.map(spot).join("L")}Z` : "";
  const first = inside.findIndex((yes, i) => yes && !inside[(i + n - 1) % n]);
  if (first < 0) return "";
  let text = "";
  let left = null;
  for (let k = 0; k < n; k += 1) {
    const i = (first + k) % n;
    const before = (i + n - 1) % n;
    if (inside[i] && !inside[before]) {
      const entry = onLimb(curve[before], curve[i]);
      text += left ? alongLimb(left, entry, side) : `M${spot(entry)}`;
    }
    if (inside[i]) text += `L${spot(curve[i])}`;
    else if (inside[before]) {
      left = onLimb(curve[before], curve[i]);
      text += `L${spot(left)}`;
    }
  }
  const entry = onLimb(curve[(first + n - 1) % n], curve[first]);
  return `${text}${alongLimb(left, entry, side)}Z`;
}

// Twice the area of a polygon on paper, positive when it goes counterclockwise.
function area(corners) {
  return corners.reduce((sum, p, i) => {
    const q = corners[(i + 1) % corners.length];
    return sum + p[0] * q[1] - p[1] * q[0];
  }, 0);
}

function alongLimb(from, to, side) {
  let angle = side * (Math.atan2(to[1], to[0]) - Math.atan2(from[1], from[0]));
  angle = ((angle % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI);
  if (angle > 2 * Math.PI - 1e-6) angle = 0;
  const large = angle > Math.PI ? 1 : 0;
  return `A${RADIUS} ${RADIUS} 0 ${large} ${side > 0 ? 0 : 1} ${spot(to)}`;
}

// A whole region; one without a boundary is the whole half.
function regionPath(region, frame, side) {
  const disk = `M${-RADIUS},0A${RADIUS} ${RADIUS} 0 0 0 ${RADIUS},0A${RADIUS} ${RADIUS} 0 0 0 ${-RADIUS},0Z`;
  if (!region.arcs.length) return disk;
  return region.pieces.map((piece) => clipped(boundary(piece, frame), side)).join("");
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
  const square = (x * x + y * y) / (RADIUS * RADIUS);
  if (square > 1) return null;
  const local = [x / RADIUS, y / RADIUS, Math.sqrt(1 - square)];
  const p = [0, 1, 2].map((i) => local[0] * axes[0][i] + local[1] * axes[1][i] + local[2] * axes[2][i]);
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
