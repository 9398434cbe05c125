// Pictures of the projective plane: a linear map takes (x, y, z) to (X, Y, W), drawn at X/W, Y/W.
// Places of the picture are rounded to exact points; lines go through those.

// A chart: matrix and its inverse, what lies at infinity, and steps to the right and up.
const CHARTS = {
  z: permuted("z = 1", 0),
  x: permuted("x = 1", 1),
  y: permuted("y = 1", 2),
  sum: barycentric(),
};

function permuted(name, shift) {
  const axis = (k) => [0, 1, 2].map((i) => (i === (k + shift) % 3 ? 1n : 0n));
  const matrix = [0, 1, 2].map((k) => axis(k).map(Number));
  return {
    name, matrix, inverse: [0, 1, 2].map((i) => matrix.map((row) => row[i])),
    infinity: axis(2), right: axis(0), up: axis(1),
    snap: (X, Y, grid) => {
      const place = [Math.round(X * grid), Math.round(Y * grid), grid];
      return [0, 1, 2].map((i) => BigInt(place[(i - shift + 3) % 3]));
    },
  };
}

// Seen along (1, 1, 1): the coordinate planes are the sides of a triangle.
function barycentric() {
  const corners = [[-Math.sqrt(3), -1], [Math.sqrt(3), -1], [0, 2]];
  const inverse = corners.map(([x, y]) => [x / 6, y / 6, 1 / 3]);
  return {
    name: "x + y + z = 1", matrix: [corners.map(([x]) => x), corners.map(([, y]) => y), [1, 1, 1]], inverse,
    infinity: [1n, 1n, 1n], right: [-1n, 1n, 0n], up: [-1n, -1n, 2n],
    snap: (X, Y, grid) => {
      const [a, b] = inverse.map(([p, q, r]) => Math.round(3 * grid * (p * X + q * Y + r)));
      return [BigInt(a), BigInt(b), BigInt(3 * grid - a - b)];
    },
  };
}

const chartOf = () => CHARTS[state.dimension === 2 ? "z" : state.chart];
// (X, Y, W) of a point; the line (m0, m1, m2) has m0 X + m1 Y + m2 W = 0.
/** @type {(ray: bigint[]) => number[]} */ const charted = (ray) => turned(chartOf().matrix, floats(ray));
/** @type {(normal: bigint[]) => number[]} */
function lineIn(normal) {
  const { inverse } = chartOf();
  const n = floats(normal);
  return [0, 1, 2].map((k) => n[0] * inverse[0][k] + n[1] * inverse[1][k] + n[2] * inverse[2][k]);
}

// Both ends of the part of a line that is seen; null if none is.
/** @type {(line: number[], frame: { low: number[], high: number[] }) => number[][] | null} */
function seenPart([a, b, c], { low, high }) {
  const length = Math.hypot(a, b);
  if (length < 1e-12) return null;
  const [u, v] = [-b / length, a / length];
  const d = (a * state.middle[0] + b * state.middle[1] + c) / (length * length);
  const foot = [state.middle[0] - a * d, state.middle[1] - b * d];
  let [from, to] = [-Infinity, Infinity];
  [u, v].forEach((way, k) => {
    if (Math.abs(way) < 1e-12) {
      if (foot[k] < low[k] || foot[k] > high[k]) to = -Infinity;
      return;
    }
    const ends = [(low[k] - foot[k]) / way, (high[k] - foot[k]) / way].sort((x, y) => x - y);
    from = Math.max(from, ends[0]);
    to = Math.min(to, ends[1]);
  });
  return from < to ? [from, to].map((t) => [foot[0] + t * u, foot[1] + t * v]) : null;
}

// Into sight: crossings, but for those of two lines that are far out, and the middle of each line.
function fitPlane() {
  const { circles, infinity } = shown().arrangement;
  const points = circles.crossings.map(({ ray, on }) => [...charted(ray), on.length > 2]).filter(([, , w]) => Math.abs(w) > 1e-9)
    .map(([x, y, w, often]) => ({ place: [x / w, y / w], often }));
  circles.normals.forEach((n, i) => {
    const [a, b, c] = lineIn(n);
    if (i !== infinity && Math.hypot(a, b) > 1e-9) points.push({ place: [(-a * c) / (a * a + b * b), (-b * c) / (a * a + b * b)], often: true });
  });
  const middle = [0, 1].map((k) => points.map(({ place: p }) => p[k]).sort((x, y) => x - y)[points.length >> 1] ?? 0);
  const far = points.map(({ place: p }) => Math.hypot(p[0] - middle[0], p[1] - middle[1])).sort((x, y) => x - y);
  const limit = 1.01 * (far[Math.ceil(0.85 * (far.length - 1))] ?? 1);
  const inside = points.filter(({ place: p, often }) => often || Math.hypot(p[0] - middle[0], p[1] - middle[1]) <= limit);
  const [low, high] = [Math.min, Math.max].map((end) => [0, 1].map((k) => end(...inside.map(({ place: p }) => p[k]))));
  const reach = inside.length ? Math.max((high[1] - low[1]) / 2, ((high[0] - low[0]) / 2) * (HIGH / WIDE)) : 0;
  Object.assign(state, { middle: inside.length ? [0, 1].map((k) => (low[k] + high[k]) / 2) : [0, 0], half: 1.25 * reach || 2 });
}

// An exact point of a line near a place of the chart.
/** @type {(normal: bigint[], place: number[]) => bigint[]} */
function onLine(normal, [X, Y]) {
  const chart = chartOf();
  const [a, b] = lineIn(normal);
  const way = Math.abs(a) > Math.abs(b) ? chart.right : chart.up;
  const point = crossOf(normal, crossOf(chart.snap(X, Y, gridSteps()), way));
  return facing(primitive(point));
}

const weight = (point) => dotOf(chartOf().infinity, point);
const facing = (point) => (weight(point) < 0n ? opposite(point) : point);

// Coordinates of the ball and of the dual: as given, or those of the picture of lines, so that nearly parallel
// arrangements fill them. Signs are the same in both.
function shapeOf(even) {
  const { matrix, inverse } = chartOf();
  const { middle: [x, y], half } = state;
  const product = (a, b) => a.map((row) => [0, 1, 2].map((k) => row[0] * b[0][k] + row[1] * b[1][k] + row[2] * b[2][k]));
  const points = even ? product([[1 / half, 0, -x / half], [0, 1 / half, -y / half], [0, 0, 1]], matrix) : CHARTS.z.matrix;
  const back = even ? product(inverse, [[half, 0, x], [0, half, y], [0, 0, 1]]) : CHARTS.z.matrix;
  return { even, points, normals: flipped(back) };
}

const flipped = (matrix) => [0, 1, 2].map((k) => matrix.map((row) => row[k]));
// The normal, in the coordinates of the planes, of a circle of the ball.
const normalFrom = (v) => turned(flipped(state.shape.points), v);

// Whether the normals lie near one plane, so that most crossings crowd together.
function isNarrow(normals) {
  const units = normals.map((n) => unit(floats(n)));
  const sums = [0, 1, 2].map((i) => [0, 1, 2].map((j) => units.reduce((sum, n) => sum + n[i] * n[j], 0) / units.length));
  return units.length > 2 && dot(sums[0], cross(sums[1], sums[2])) < 0.1 / 27;
}
