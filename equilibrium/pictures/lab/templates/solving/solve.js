// The decision: a tree that tells apart the states of contacts. Where the closed linear system of a
// node has no solution, Farkas' multipliers give a virtual motion that proves it; a node that has all
// states decided and a solution is an equilibrium. All numbers are exact.
const SPLITS = { undecided: ["attachment", ["detached", "attached"]], attached: ["slip", ["stick", "slip+", "slip-"]] };

// Returns { stable, equilibria: one or none, tree: the proof or null }; yields null now and then.
function* treeOf(grasp, wrench) {
  let equilibrium = null;
  const question = inIntegers(grasp, wrench);
  const whole = wholeSpace(question);
  function* node(states, guide) {
    const root = guide.root;
    const open = states.some((state) => state in SPLITS);
    if (!guide.feasible()) {
      const leaf = blamedLeaf(grasp, wrench, states, guide);
      if (leaf && !leafProblem(question, whole, states, leaf)) return leaf;
    }
    if (root || !open || guide.blamed) {
      const { system, found } = solutionsOf(grasp, states, wrench);
      if (!found.feasible()) return leafOf(grasp, wrench, states, system, found.refuted);
      if (!open) {
        equilibrium = yield* equilibriaWith(grasp, states, wrench);
        return null;
      }
    }
    yield null;
    const places = guide.contacts(grasp, states);
    if (places.every(({ broken }) => broken < 1e-6)) {
      // Floats seem to obey the law of all contacts.
      const guess = places.map(({ state }) => state);
      if (solutionsOf(grasp, guess, wrench).found.feasible()) {
        equilibrium = yield* equilibriaWith(grasp, guess, wrench);
        return null;
      }
    }
    const i = mostBroken(states, places);
    const [kind, names] = SPLITS[states[i]];
    const children = {};
    // First the state in which floats see the contact.
    const here = places[i].state;
    for (const name of names.toSorted((a, b) => Number(b === here) - Number(a === here))) {
      children[name] = yield* node(states.with(i, name), guide.child(i, name));
      if (equilibrium) return null;
    }
    return { contact: i, [kind]: Object.fromEntries(names.map((name) => [name, children[name]])) };
  }
  const tree = yield* node(grasp.map(() => "undecided"), Guide.root(grasp, wrench));
  // Nothing is shown that the checker does not confirm.
  const problem = equilibrium ? "" : treeProblem(grasp, wrench, tree).problem;
  if (problem) throw new Error(`fault of this page: ${problem}`);
  return { stable: Boolean(equilibrium), equilibria: equilibrium ? [equilibrium] : [], tree };
}

// All equilibria under a wrench, by the pieces of all choices of states that occur.
function* equilibriaOf(grasp, wrench, pieces) {
  let found = [];
  for (const { states } of piecesAt(pieces, [...wrench, ONE])) {
    found = joined(grasp, found, yield* equilibriaWith(grasp, states, wrench));
    yield null;
  }
  return found;
}

// What a generator returns.
function drained(search) {
  let step = search.next();
  while (!step.done) step = search.next();
  return step.value;
}

const firstOf = (grasp, wrench) => drained(treeOf(grasp, wrench));

// The closed linear system of a choice of states; `free` is how many unknowns the load has.
function solutionsOf(grasp, states, wrench, { printed = false, load = loadOf(wrench), watched = [] } = {}) {
  const system = systemOf(grasp, states, load, { free: load[0].length - 1, printed });
  const wide = watched.map((k) => unitRow(system, k));
  return { system, found: new Dictionary(system.n, [...system.balance, ...rowsOf(system.equal)], rowsOf(system.atLeast), wide) };
}

const unitRow = ({ n }, k) => Array.from({ length: n + 1 }, (_, j) => (j === k ? ONE : ZERO));

// The contact to decide next: the one whose law floats break most.
function mostBroken(states, places) {
  let [found, most] = [-1, -1];
  places.forEach(({ broken }, i) => { if (states[i] in SPLITS && (broken > most || found < 0)) [found, most] = [i, broken]; });
  return found;
}

// The leaf of a refuted node: virtual motion, and (alpha, h) of each contact. With e the force that the
// spring of a contact would have and s its slip, load . motion + sum (alpha e + h s) = room > 0 for all
// motions, and what a contact can do works at least alpha e + h s.
function leafOf(grasp, wrench, states, system, y) {
  const motion = y.slice(0, 3).map(minus);
  const multipliers = grasp.map((contact) => {
    const { N, T } = wrenchesOf(contact);
    return { a: dotted(motion, N), b: dotted(motion, T), alpha: null, h: ZERO, cut: ZERO };
  });
  [...system.equal, ...system.atLeast].forEach(({ name, contact: i }, k) => {
    const one = multipliers[i];
    const value = y[3 + k];
    if (name === "least" || name === "spring") one.alpha = value;
    else if (name === "normal") one.cut = plus(one.cut, value);
    else if (name === "cone") one.cut = plus(one.cut, times(grasp[i].friction, value));
    else one.h = states[i] === "slip-" ? value : minus(value);
  });
  const pairs = multipliers.map(({ a, b, alpha, h, cut }, i) => {
    const rub = times(grasp[i].friction, b);
    const kappa = states[i] === "slip+" ? less(a, rub) : states[i] === "slip-" ? plus(a, rub) : a;
    return [alpha ?? less(kappa, cut), h];
  });
  return { motion, multipliers: pairs, states, ...shortened(grasp, motion, pairs, wrench) };
}

// The numbers of a leaf over its largest entry, as integers without common divisor.
function shortened(grasp, motion, pairs, wrench) {
  const largest = integers(motion).row.reduce(gcdOf, 0n);
  const factor = largest ? ratio(integers(motion).scale, largest) : ONE;
  const multipliers = pairs.map((pair) => scaledBy(pair, factor));
  const scaled = scaledBy(motion, factor);
  const work = dotted(scaled, wrench);
  const room = grasp.reduce((sum, contact, i) => plus(sum, times(multipliers[i][0], contact.preload)), work);
  return { motion: scaled, multipliers, work, room };
}

// All equilibria with one choice of states: a point, or a polyhedron with the range of each component.
// Of a polyhedron a middle one is shown: component by component, half way between its ends.
function* equilibriaWith(grasp, states, wrench) {
  const { system, found } = solutionsOf(grasp, states, wrench);
  found.feasible();
  const at = (z) => (row) => dotted(row, [...z, ONE]);
  const shape = (z) => ({ motion: z.slice(0, 3), forces: system.forces.map((pair) => pair.map(at(z))) });
  const one = ({ motion, forces }) => {
    const problem = lawProblem(grasp, wrench, motion, forces);
    if (problem) throw new Error(`fault of this page: ${problem}`);
    return { states: grasp.map((contact) => contactAt(contact, motion).state), motion, forces, ranges: null, points: [{ motion, forces }] };
  };
  if (found.single) return one(shape(found.point()));
  const watched = [...[0, 1, 2].map((k) => unitRow(system, k)), ...system.forces.flat()];
  const within = (fixed) => {
    const all = new Dictionary(system.n, [...system.balance, ...rowsOf(system.equal), ...fixed], rowsOf(system.atLeast), watched);
    all.feasible();
    return all;
  };
  const points = [];
  const all = within([]);
  const ranges = [];
  for (const k of watched.keys()) {
    ranges.push([-1n, 1n].map((way) => {
      const end = all.extreme(k, way);
      points.push(shape(all.point()));
      return end;
    }));
    yield null;
  }
  if (ranges.every(([low, high]) => low && high && same(low, high))) return one(points[0]);
  const fixed = [];
  for (const [k, row] of watched.entries()) {
    if (!isPoint(ranges[k])) {
      const left = within(fixed);
      fixed.push(row.with(-1, less(row.at(-1), middleOf(left.extreme(k, -1n), left.extreme(k, 1n)))));
      yield null;
    }
  }
  const { motion, forces } = one(shape(within(fixed).point()));
  return { states, motion, forces, ranges, points };
}

const isPoint = ([low, high]) => low && high && same(low, high);

function middleOf(low, high) {
  if (low && high) return times(plus(low, high), ratio(1n, 2n));
  if (low) return low.n > 0n ? low : ZERO;
  return high && high.n < 0n ? high : ZERO;
}

// With a further piece: those that lie in no other one (closed conditions let one equilibrium appear in
// several states).
function joined(grasp, pieces, piece) {
  const endless = ({ ranges }) => ranges?.some((range) => range.includes(null));
  const within = (one, other) => (!endless(one) || endless(other))
    && one.points.every(({ motion, forces }) => holds(grasp, other, motion, forces));
  return pieces.some((other) => within(piece, other)) ? pieces : [...pieces.filter((other) => !within(other, piece)), piece];
}

// Whether an equilibrium (motion, forces) is one of those of a piece, by its closed conditions.
function holds(grasp, piece, motion, forces) {
  if (!piece.ranges) {
    return piece.motion.every((x, k) => same(x, motion[k])) && piece.forces.flat().every((x, k) => same(x, forces.flat()[k]));
  }
  return grasp.every((contact, i) => {
    const { spring, slip } = contactAt(contact, motion);
    const [normal, tangential] = forces[i];
    /** @type {bigint | undefined} */ const way = { "slip+": 1n, "slip-": -1n }[piece.states[i]];
    if (piece.states[i] === "detached") return spring.n <= 0n && !normal.n && !tangential.n;
    if (!same(normal, spring)) return false;
    if (!way) return slip.n === 0n;
    return slip.n * way >= 0n && same(tangential, times(times(ratio(-way), contact.friction), normal));
  });
}

const texts = (row) => row.map(textOf);

// The certificate of a verdict, in the form that `equilibrium verify` reads.
function certificateOf(grasp, wrench, found) {
  const base = { schema_version: 4, certificate: found.stable ? "resisted" : "not resisted",
    grasp: documentOf(grasp), wrench: texts(wrench) };
  if (found.stable) {
    const { motion, forces } = found.equilibria[0];
    return { ...base, motion: texts(motion), forces: forces.map(texts) };
  }
  const written = (node) => {
    if (node.motion) {
      const used = node.multipliers.map((pair, i) => [String(i), texts(pair)]);
      return { virtual_motion: texts(node.motion), multipliers: Object.fromEntries(used) };
    }
    const [kind] = ["attachment", "slip"].filter((key) => key in node);
    const children = Object.entries(node[kind]).map(([name, child]) => [name, written(child)]);
    return { contact: node.contact, [kind]: Object.fromEntries(children) };
  };
  return { ...base, tree: written(found.tree) };
}

// The leaves of a proof, from left to right.
function leavesOf(node) {
  if (!node) return [];
  if (node.motion) return [node];
  return Object.values(node.attachment ?? node.slip).flatMap(leavesOf);
}
