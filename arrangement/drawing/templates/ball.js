// A ball seen from far away: what of curves and areas on it lies on the half that is seen.
const RADIUS = 100;
const turned = (axes, p) => axes.map((axis) => dot(axis, p));
const spot = (p) => `${fixed(RADIUS * p[0])},${fixed(-RADIUS * p[1])}`;

// The axes of a ball after a small turn. Round-off in thousands of turns must not bend them.
/** @type {(axes: number[][], right: number, up: number) => number[][]} */
function turnedAxes([x, y, z], right, up) {
  const mix = (u, v, a) => u.map((c, i) => Math.cos(a) * c + Math.sin(a) * v[i]);
  const side = mix(z, x, -right);
  const ahead = unit(mix(side, y, up));
  const across = unit(cross(mix(y, side, -up), ahead));
  return [across, cross(ahead, across), ahead];
}

// The axes for a direction towards the viewer and one that is up, or nearly.
function axesFor(ahead, up) {
  const across = unit(cross(up, ahead));
  return [across, cross(ahead, across), ahead];
}

// The direction that is seen at a place of the disk of radius 1.
function directionAt(axes, u, v) {
  const w = Math.sqrt(Math.max(0, 1 - u * u - v * v));
  return [0, 1, 2].map((k) => u * axes[0][k] + v * axes[1][k] + w * axes[2][k]);
}

// Points along an arc, both ends included; of a whole circle where nothing crosses it.
function curveOf(normal, start, stop) {
  const from = start ?? unit(cross(normal, Math.abs(normal[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]));
  const angle = start ? Math.atan2(Math.hypot(...cross(from, stop)), dot(from, stop)) : 2 * Math.PI;
  const side = cross(normal, from);
  const pieces = Math.max(1, Math.ceil((angle * 60) / Math.PI));
  return Array.from({ length: pieces + 1 }, (_, k) => {
    const a = (angle * k) / pieces;
    return from.map((x, j) => Math.cos(a) * x + Math.sin(a) * side[j]);
  });
}

// Where the way from a visible point to a hidden one leaves the visible half.
function onLimb(p, q) {
  const s = p[2] / (p[2] - q[2]);
  const x = p[0] + s * (q[0] - p[0]);
  const y = p[1] + s * (q[1] - p[1]);
  const n = Math.hypot(x, y) || 1;
  return [x / n, y / n, 0];
}

// The boundary of a region, from the curves of its darts, as one closed curve; dart 2e + 1 is arc e backwards.
const boundaryOf = (darts, curves) => darts.flatMap((dart) => (dart & 1 ? [...curves[dart >> 1]].reverse() : curves[dart >> 1]).slice(0, -1));

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

function alongLimb(from, to, side) {
  let angle = side * (Math.atan2(to[1], to[0]) - Math.atan2(from[1], from[0]));
  angle = ((angle % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI);
  if (angle > 2 * Math.PI - 1e-6) angle = 0;
  const large = angle > Math.PI ? 1 : 0;
  return `A${RADIUS} ${RADIUS} 0 ${large} ${side > 0 ? 0 : 1} ${spot(to)}`;
}
