// Convex polygons in floats: for pictures.
// What of a convex polygon is on the side a x + b y + c >= 0.
/** @type {(corners: number[][], line: number[], tolerance: number) => number[][]} */
function cut(corners, [a, b, c], tolerance) {
  const length = Math.hypot(a, b);
  /** @type {(p: number[]) => number} */ const height = ([x, y]) => (length ? (a * x + b * y + c) / length : c);
  const least = length ? -tolerance : -1e-12;
  const found = [];
  corners.forEach((p, i) => {
    const q = corners[(i + 1) % corners.length];
    const [s, t] = [height(p), height(q)];
    if (s >= least) found.push(p);
    if ((s < least && t > 0) || (s > 0 && t < least)) {
      const share = s / (s - t);
      found.push([p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])]);
    }
  });
  return found;
}

/** @type {(points: number[][]) => string} */ const pathOf = (points) => `M${points.map((p) => p.map(fixed).join(",")).join("L")}`;
