// A ball seen from far away: what of curves and areas on it lies on the half that is seen.
const RADIUS = 100;
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0],
];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = (a) => { const n = Math.hypot(...a); return a.map((x) => x / n); };
const turned = (axes, p) => axes.map((axis) => dot(axis, p));
const fixed = (x) => (Math.round(x * 10) / 10).toString();
const spot = (p) => `${fixed(RADIUS * p[0])},${fixed(-RADIUS * p[1])}`;

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
