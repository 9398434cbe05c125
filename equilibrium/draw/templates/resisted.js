// Pieces of the resisted wrenches, as `pieceFrom` finds them. A condition (a, b, c, d) says
// a f_x + b f_y + c τ + d p >= 0 for the force (f_x, f_y), the torque τ and the factor p of the preloads.
function scaled(row) {
  const largest = Math.max(...row.map(Math.abs)) || 1;
  return row.map((x) => x / largest);
}

// The exact sign of a form at a point; floats decide where they are far from doubt, else what `point` gives.
function signOf(row, point, floats) {
  let [sum, size] = [0, 0];
  row.float.forEach((x, i) => { sum += x * floats[i]; size += Math.abs(x * floats[i]); });
  if (Math.abs(sum) > 1e-9 * size) return Math.sign(sum);
  const value = dotted(row.exact, point()).n;
  return value > 0n ? 1 : value < 0n ? -1 : 0;
}

function piecesAt(pieces, point) {
  const floats = point.map(near);
  return pieces.filter((piece) => piece.equal.every((row) => signOf(row, () => point, floats) === 0)
    && piece.atLeast.every((row) => signOf(row, () => point, floats) >= 0));
}

// The pieces that lie in no other one; of equal ones the first.
function maximal(list) {
  const floats = new Map(list.map((piece) => [piece, piece.ends.map((end) => ({ end, float: scaled(end.map((x) => near(ratio(x)))) }))]));
  const within = (one, other) => floats.get(one).every(({ end, float }) => {
    const exact = () => end.map((x) => ratio(x));
    return other.equal.every((row) => signOf(row, exact, float) === 0) && other.atLeast.every((row) => signOf(row, exact, float) >= 0);
  });
  return list.reduce((left, piece) => (left.some((other) => within(piece, other)) ? left
    : [...left.filter((other) => !within(other, piece)), piece]), []);
}

// What nine of ten corners do not exceed, by a size of (f_x, f_y, τ) at p = 1: few may be very far away.
function typical(list, sizeOf) {
  const sizes = list.flatMap(({ ends }) => ends.filter((end) => end[3] > 0n).map((end) => sizeOf(end.map((x) => Math.abs(near({ n: x, d: end[3] }))))));
  const sorted = sizes.filter((x) => x).toSorted((a, b) => a - b);
  return sorted[Math.floor(0.9 * (sorted.length - 1))] ?? 0;
}
