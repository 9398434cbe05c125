// The space of motions: the contact states that occur, and the cells of its slices at r = turn, -turn.
// Exact: a motion lies in one state each, so the states found here are all there are. Only cells that
// exist are walked: contact by contact a cone of vectors (d, p), for motions d / p, is cut by planes.
// Among `names` "attached" tells no slips apart; without "detached" springs do not count.
function* statesOf(grasp, names = STATES) {
  const rows = grasp.map((contact) => {
    const { N, T } = wrenchesOf(contact);
    const [spring, slip] = [[...scaledBy(N, minus(contact.stiffness)), contact.preload], [...T, ZERO]].map((row) => integers(row).row);
    const [back, lower] = [spring, slip].map((row) => row.map((x) => -x));
    const touching = names.includes("detached") ? [{ row: spring, kind: "above" }] : [];
    const slips = { "slip+": [{ row: slip, kind: "above" }], "slip-": [{ row: lower, kind: "above" }], stick: [{ row: slip, kind: "on" }], attached: [] };
    return names.map((name) => ({ name, cuts: name === "detached" ? [{ row: back, kind: "from" }] : [...touching, ...slips[name]] }));
  });
  // A closed cone has points with all strict conditions if each of them is above 0 at some ray.
  const taken = ({ cone, strict }, { row, kind }) => {
    const left = cutCone(cone, row, kind !== "on");
    const due = kind === "above" ? strict | cone.bit : strict;
    return left.rays.reduce((common, { zeros }) => common & zeros, due) ? null : { cone: left, strict: due };
  };
  function* below(states, cell) {
    const i = states.length;
    if (i === grasp.length) {
      const sum = cell.cone.rays.reduce((total, { v }) => total.map((x, j) => x + v[j]), [0n, 0n, 0n, 0n]);
      yield { states, motion: sum.slice(0, 3).map((x) => ratio(x, sum[3])), cone: cell.cone };
      return;
    }
    yield null;
    for (const { name, cuts } of rows[i]) {
      const part = cuts.reduce((left, cut) => left && taken(left, cut), cell);
      if (part) yield* below([...states, name], part);
    }
  }
  yield* below([], taken({ cone: wholeCone(4), strict: 0n }, { row: [0n, 0n, 0n, 1n], kind: "above" }));
}

// The planes of a slice r = way * turn, as rows in (x, y, h): the motion is turn (x, y, way h) / h.
function sliceRows(grasp, turn, way) {
  const sign = ratio(BigInt(way));
  return grasp.map((contact) => {
    const { N, T } = wrenchesOf(contact);
    const stiff = times(contact.stiffness, turn);
    return {
      slip: integers([T[0], T[1], times(sign, T[2])]).row,
      spring: integers([times(minus(stiff), N[0]), times(minus(stiff), N[1]),
        less(contact.preload, times(times(sign, stiff), N[2]))]).row,
    };
  });
}

// The quarters of the half space h >= 0, as pointed cones of three rays.
const QUARTERS = [[1n, 1n], [-1n, 1n], [-1n, -1n], [1n, -1n]]
  .map(([x, y]) => [[x, 0n, 0n], [0n, y, 0n], [0n, 0n, 1n]]);

// What the planes cut the half space h >= 0 into, each part within one quarter: rays in cyclic order.
const partsOf = (rows) => rows.reduce((parts, row) => parts.flatMap((part) => [row, row.map((x) => -x)]
  .map((side) => clipped(part, side)).filter(Boolean)), QUARTERS);
const inside = (part) => part.reduce((sum, ray) => sum.map((x, k) => x + ray[k]));

// The cells of a slice by contact states: parts of one cell lie in different quarters, or differ in
// the slip of contacts that do not touch.
function cellsOf(grasp, turn, way) {
  const rows = sliceRows(grasp, turn, way);
  const cells = new Map();
  for (const part of partsOf(rows.flatMap(({ slip, spring }) => [slip, spring]).filter((row) => row.some((x) => x)))) {
    const states = rows.map((row) => stateAt(row, inside(part)));
    const cell = cells.get(String(states)) ?? { way, states, parts: [], rows: rows.flatMap(({ slip, spring }, i) => (states[i] === "detached" ? [spring] : [slip, spring])) };
    cell.parts.push(part);
    cells.set(String(states), cell);
  }
  return [...cells.values()];
}

function stateAt({ slip, spring }, ray) {
  const [s, e] = [dotOf(slip, ray), dotOf(spring, ray)];
  return e <= 0n ? "detached" : s > 0n ? "slip+" : s < 0n ? "slip-" : "stick";
}

// What of a cell is on the side row . v >= 0; null if that has no interior.
function clipped(corners, row) {
  const heights = corners.map((ray) => dotOf(row, ray));
  if (!heights.some((h) => h > 0n)) return null;
  return corners.flatMap((ray, i) => {
    const next = (i + 1) % corners.length;
    const [a, b] = [heights[i], heights[next]];
    const crossing = (a > 0n && b < 0n) || (a < 0n && b > 0n);
    const between = () => primitive(corners[next].map((x, k) => (a > 0n ? a * x - b * ray[k] : b * ray[k] - a * x)));
    return [...(a >= 0n ? [ray] : []), ...(crossing ? [between()] : [])];
  });
}
