// The law of contacts, and the closed linear system of a choice of contact states.
// A contact: { point, normal, friction, stiffness, preload }, exact; a motion d = (x, y, r).
const STATES = ["detached", "slip+", "slip-", "stick"];

// N and T, the wrenches of unit forces; the same vectors give displacements from motions.
function wrenchesOf({ point: [x, y], normal: [nx, ny] }) {
  return {
    N: [nx, ny, less(times(x, ny), times(y, nx))],
    T: [minus(ny), nx, plus(times(x, nx), times(y, ny))],
  };
}

// What the law says of one contact at a motion, without friction forces at rest.
function contactAt(contact, motion) {
  const { N, T } = wrenchesOf(contact);
  const spring = less(contact.preload, times(contact.stiffness, dotted(N, motion)));
  const slip = dotted(T, motion);
  const state = spring.n <= 0n ? "detached" : slip.n > 0n ? "slip+" : slip.n < 0n ? "slip-" : "stick";
  return { spring, slip, state };
}

// The conditions of one contact in (d, own unknowns, 1): equal rows = 0, atLeast rows >= 0, and the
// normal and tangential force. The names of the rows say which condition each one is.
// "free" is a force in its cone that no spring gives. As printed, friction pulls along the slip, and
// nothing asks whether the motion slips that way.
function partOf(contact, state, printed = false) {
  const { N, T } = wrenchesOf(contact);
  const own = { undecided: 2, free: 2, attached: 1, stick: 1 }[state] ?? 0;
  const unit = (k) => [...N.map(() => ZERO), ...Array.from({ length: own }, (_, i) => (i === k ? ONE : ZERO)), ZERO];
  const none = unit(-1);
  const padded = (row, constant) => [...row, ...Array.from({ length: own }, () => ZERO), constant];
  const spring = padded(scaledBy(N, minus(contact.stiffness)), contact.preload);
  const slip = padded(T, ZERO);
  const mu = contact.friction;
  /** @type {any} */ const part = { own, equal: [], atLeast: [], normal: none, tangential: none };
  const put = (name, row) => part.atLeast.push({ name, row });
  const cone = () => {
    put("cone", added(scaledBy(part.normal, mu), minusRow(part.tangential)));
    put("cone", added(scaledBy(part.normal, mu), part.tangential));
  };
  if (state === "detached") put("spring", minusRow(spring));
  else if (own === 2) {
    [part.normal, part.tangential] = [unit(0), unit(1)];
    if (state === "undecided") put("least", added(part.normal, minusRow(spring)));
    put("normal", part.normal);
    cone();
  } else {
    part.normal = spring;
    put("normal", spring);
    if (own) {
      part.tangential = unit(0);
      cone();
      if (state === "stick") part.equal.push({ name: "stick", row: slip });
    } else {
      const way = state === "slip+" ? ONE : minus(ONE);
      part.tangential = scaledBy(spring, times(mu, printed ? way : minus(way)));
      if (!printed) put("direction", scaledBy(slip, way));
    }
  }
  return part;
}

// Contacts never change, so what follows from one is kept with it: its part, and the wrench of its forces
// as three rows in (d, own unknowns, 1), also as integers over one scale, in (d, 1, own unknowns).
const kept = new WeakMap();
function keptPart(contact, state, printed) {
  if (!kept.has(contact)) kept.set(contact, new Map());
  const parts = kept.get(contact);
  const key = `${state}${printed}`;
  if (!parts.has(key)) {
    const part = partOf(contact, state, printed);
    const { N, T } = wrenchesOf(contact);
    part.wrench = [0, 1, 2].map((j) => added(scaledBy(part.normal, N[j]), scaledBy(part.tangential, T[j])));
    const turned = (row) => [...row.slice(0, 3), row.at(-1), ...row.slice(3, -1)];
    part.whole = integers(part.wrench.flatMap(turned));
    part.cuts = ["equal", "atLeast"].flatMap((kind) => part[kind].map(({ row }) => ({ keep: kind === "atLeast", row: integers(turned(row)).row })));
    parts.set(key, part);
  }
  return parts.get(key);
}

// The rows of all contacts in common unknowns: d, `free` further ones, then those of each contact.
// The balance, sum of forces + w = 0, has w from `load`: rows in the free unknowns and 1.
function systemOf(grasp, states, load, { free = 0, printed = false } = {}) {
  const parts = grasp.map((contact, i) => keptPart(contact, states[i], printed));
  const starts = [];
  let n = 3 + free;
  for (const part of parts) { starts.push(n); n += part.own; }
  const spread = (row, start) => {
    const wide = Array.from({ length: n + 1 }, () => ZERO);
    row.slice(0, -1).forEach((x, j) => { wide[j < 3 ? j : start + j - 3] = x; });
    wide[n] = row.at(-1);
    return wide;
  };
  const balance = load.map((row) => spread([ZERO, ZERO, ZERO, ...row], 3));
  const forces = parts.map((part, i) => [spread(part.normal, starts[i]), spread(part.tangential, starts[i])]);
  parts.forEach((part, i) => balance.forEach((row, j) => {
    spread(part.wrench[j], starts[i]).forEach((x, c) => { if (x.n) row[c] = row[c].n ? plus(row[c], x) : x; });
  }));
  const [equal, atLeast] = ["equal", "atLeast"].map((kind) => parts.flatMap((part, i) => part[kind]
    .map(({ name, row }) => ({ name, contact: i, row: spread(row, starts[i]) }))));
  return { n, balance, equal, atLeast, forces };
}

const rowsOf = (list) => list.map(({ row }) => row);
const loadOf = (wrench) => wrench.map((x) => [x]);
