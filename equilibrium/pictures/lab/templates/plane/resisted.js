// Pieces of the resisted wrenches, as `pieceFrom` finds them. A condition (a, b, c, d) says
// a f_x + b f_y + c τ + d p >= 0 for the force (f_x, f_y), the torque τ and the factor p of the preloads.
function scaled(row) {
  const largest = Math.max(...row.map(Math.abs)) || 1;
  return row.map((x) => x / largest);
}

// The sign of a sum of products, where floats are far from doubt; else null.
function sureSign(row, floats) {
  let [sum, size] = [0, 0];
  for (let i = 0; i < row.length; i += 1) {
    const share = row[i] * floats[i];
    sum += share;
    size += Math.abs(share);
  }
  return Math.abs(sum) > 1e-9 * size ? Math.sign(sum) : null;
}

// The exact sign of a form at a point.
const signAt = (row, point, floats) => sureSign(row.float, floats) ?? order(dotted(row.exact, point), ZERO);

function piecesAt(pieces, point) {
  const floats = point.map(near);
  return pieces.filter((piece) => piece.equal.every((row) => signAt(row, point, floats) === 0)
    && piece.atLeast.every((row) => signAt(row, point, floats) >= 0));
}

// Returns the pieces that lie in no other one, of equal ones the first; yields null.
function* maximal(list) {
  const floats = new Map(list.map((piece) => [piece, piece.ends.map((end) => scaled(end.map((x) => near(ratio(x)))))]));
  const within = (one, other) => {
    const sign = (row, k) => sureSign(row.float, floats.get(one)[k]) ?? order(ratio(dotOf(row.whole, one.ends[k])), ZERO);
    return one.ends.every((_, k) => other.equal.every((row) => sign(row, k) === 0) && other.atLeast.every((row) => sign(row, k) >= 0));
  };
  let left = [];
  for (const piece of list) {
    if (!left.some((other) => within(piece, other))) left = [...left.filter((other) => !within(other, piece)), piece];
    yield null;
  }
  return left;
}

// What nine of ten corners do not exceed, by a size of (f_x, f_y, τ) at p = 1: few may be very far away.
function typical(list, sizeOf) {
  const sizes = list.flatMap(({ ends }) => ends.filter((end) => end[3] > 0n).map((end) => sizeOf(end.map((x) => Math.abs(near({ n: x, d: end[3] }))))));
  const sorted = sizes.filter((x) => x).toSorted((a, b) => a - b);
  return sorted[Math.floor(0.9 * (sorted.length - 1))] ?? 0;
}
