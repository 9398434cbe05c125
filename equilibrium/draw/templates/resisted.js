// The resisted wrenches. A condition (a, b, c, d) says a f_x + b f_y + c τ + d p >= 0 for the force
// (f_x, f_y), the torque τ and the factor p of the preloads: motion, forces, wrench and preload grow
// together, so that one exact set serves for every factor above 0.
const sets = new Map(data.sets.map((set) => [set.name, set.pieces.map((piece) => readPiece(piece, set.name))]));

function readPiece(piece, name) {
  const rows = (list) => list.map((row) => {
    const exact = row.map((text) => ratio(BigInt(text)));
    return { exact, float: scaled(exact.map(near)) };
  });
  return {
    states: piece.states, raw: piece, atLeast: rows(piece.inequalities), equal: rows(piece.equalities),
    motion: piece.motion.every(Boolean) ? piece.motion.map(readForm) : null, loaded: name,
  };
}

function readForm(row) {
  return row && row.slice(0, -1).map((text) => ratio(BigInt(text), BigInt(row.at(-1))));
}

// For each contact the normal and the tangential force, as forms in wrench and preload factor;
// null where the states do not fix it.
function forcesOf(piece) {
  piece.forces ??= piece.raw.forces ? pairs(piece.raw.forces.map(readForm)) : byLaw(piece);
  return piece.forces;
}

const pairs = (list) => list.flatMap((x, i) => (i % 2 ? [] : [[x, list[i + 1]]]));

// The law of a contact: the spring gives the normal force, friction of a slipping contact follows.
function byLaw(piece) {
  const resting = piece.raw.resting.map(readForm);
  return data.contacts.map(({ exact }, i) => {
    const what = piece.states[i];
    const zero = [0n, 0n, 0n, 0n].map((x) => ratio(x));
    if (what === "detached") return [zero, zero];
    const wrench = exact.wrench.map(readNumber);
    const stiffness = times(readNumber(exact.stiffness), ratio(-1n));
    const preload = readNumber({ none: "0", uniform: "1", own: exact.preload }[piece.loaded]);
    const normal = zero.map((_, k) => plus(k === 3 ? preload : ratio(0n),
      times(stiffness, piece.motion.reduce((sum, form, j) => plus(sum, times(wrench[j], form[k])), ratio(0n)))));
    if (what === "stick") return [normal, resting.shift()];
    const pull = times(readNumber(exact.friction), ratio(what === "slip+" ? -1n : 1n));
    return [normal, normal.map((x) => times(pull, x))];
  });
}

function scaled(row) {
  const largest = Math.max(...row.map(Math.abs)) || 1;
  return row.map((x) => x / largest);
}

// The exact sign of a form at a point; floats decide only where they are far from doubt.
function signOf(row, point, floats) {
  let [sum, size] = [0, 0];
  row.float.forEach((x, i) => { sum += x * floats[i]; size += Math.abs(x * floats[i]); });
  if (Math.abs(sum) > 1e-9 * size) return Math.sign(sum);
  const value = dotted(row.exact, point).n;
  return value > 0n ? 1 : value < 0n ? -1 : 0;
}

function piecesAt(pieces, point) {
  const floats = point.map(near);
  return pieces.filter((piece) => piece.equal.every((row) => signOf(row, point, floats) === 0)
    && piece.atLeast.every((row) => signOf(row, point, floats) >= 0));
}

// The part of a piece in a rectangle of the plane of forces, as corners: a polygon, two or one.
function slice(piece, torque, factor, box) {
  const floats = [0, 0, near(torque), near(factor)];
  const line = (row) => [row.float[0], row.float[1], row.float[2] * floats[2] + row.float[3] * floats[3]];
  let corners = box;
  const tolerance = 1e-9 * Math.max(...box.flat().map(Math.abs));
  for (const row of piece.equal) {
    if (same(row.exact[0], ratio(0n)) && same(row.exact[1], ratio(0n))) {
      if (dotted(row.exact, [ratio(0n), ratio(0n), torque, factor]).n !== 0n) return [];
      continue;
    }
    corners = onLine(corners, line(row));
  }
  for (const row of piece.atLeast) corners = cut(corners, line(row), tolerance);
  return corners;
}

// Where a line meets a convex polygon: two ends, or one.
/** @type {(corners: number[][], row: number[]) => number[][]} */
function onLine(corners, [a, b, c]) {
  const length = Math.hypot(a, b);
  /** @type {(p: number[]) => number} */
  const height = ([x, y]) => (a * x + b * y + c) / length;
  const found = [];
  corners.forEach((p, i) => {
    const q = corners[(i + 1) % corners.length];
    const [s, t] = [height(p), height(q)];
    if (Math.abs(s) < 1e-9) found.push(p);
    else if (s * t < 0 && Math.abs(t) >= 1e-9) {
      const share = s / (s - t);
      found.push([p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])]);
    }
  });
  return found.filter((p, i) => found.findIndex((q) => Math.hypot(p[0] - q[0], p[1] - q[1]) < 1e-9) === i).slice(0, 2);
}

const areaOf = (corners) => Math.abs(corners.reduce((sum, p, i) => {
  const q = corners[(i + 1) % corners.length];
  return sum + p[0] * q[1] - p[1] * q[0];
}, 0)) / 2;
