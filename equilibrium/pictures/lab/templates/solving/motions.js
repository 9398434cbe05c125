// The space of motions: the contact states that occur.
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
