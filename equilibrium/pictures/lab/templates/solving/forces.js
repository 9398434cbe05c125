// The resisted wrenches: for each choice of states the cone of all (f_x, f_y, τ, p) that it balances, p
// being the factor of the preloads. Motion, forces, wrench and preload grow together, so that one exact
// cone serves for every factor above 0. It is the image of the solutions (d, p, friction at rest), which
// lie above the cone of the choice's motions, if that is known.
function pieceFrom(grasp, { states, cone = null }, printed = false) {
  const parts = grasp.map((contact, i) => keptPart(contact, states[i], printed));
  let n = 4;
  const starts = parts.map(({ own }) => (n += own) - own);
  const unit = (j) => Array.from({ length: n }, (_, k) => BigInt(j === k));
  const wide = (row, i) => [...row.slice(0, 4), ...Array.from({ length: starts[i] - 4 }, () => 0n), ...row.slice(4), ...Array.from({ length: n - starts[i] - parts[i].own }, () => 0n)];
  const longer = (v) => [...v, ...Array.from({ length: n - 4 }, () => 0n)];
  let all = cone ? { lines: [...cone.lines.map(longer), ...starts.flatMap((from, i) => Array.from({ length: parts[i].own }, (_, k) => unit(from + k)))],
    rays: cone.rays.map(({ v, zeros }) => ({ v: longer(v), zeros })), bit: cone.bit } : cutCone(wholeCone(n), unit(3));
  parts.forEach(({ cuts }, i) => {
    for (const { row, keep } of cuts) if (!cone || row.slice(4).some((x) => x)) all = cutCone(all, wide(row, i), keep);
  });
  // The wrench that all forces together balance, over a scale that is common to all contacts.
  /** @type {bigint} */ const scale = parts.reduce((common, { whole }) => common * (whole.scale / gcdOf(common, whole.scale)), 1n);
  const image = (v) => {
    /** @type {bigint[]} */ const sum = [0n, 0n, 0n, scale * v[3]];
    parts.forEach(({ own, whole }, i) => {
      const x = [...v.slice(0, 4), ...v.slice(starts[i], starts[i] + own)];
      const factor = scale / whole.scale;
      for (const j of [0, 1, 2]) sum[j] -= factor * dotOf(x, whole.row.slice(j * (4 + own), (j + 1) * (4 + own)));
    });
    return primitive(sum);
  };
  const ends = all.rays.map(({ v }) => image(v));
  const hull = generators(4, ends, all.lines.map(image));
  const conditions = (list) => list.map((condition) => {
    const exact = condition.map((x) => ratio(x));
    return { whole: condition, exact, float: scaled(exact.map(near)) };
  });
  return { states, ends, atLeast: conditions(hull.rays.filter((one) => one.slice(0, 3).some((x) => x))), equal: conditions(hull.lines) };
}

// The pieces of a list of choices; null now and then, so that others get their turn.
function* piecesOf(grasp, choices, printed = false) {
  for (const one of choices) yield one && pieceFrom(grasp, one, printed);
}
