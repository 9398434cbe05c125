// Exercises: whether the present state reaches a goal, and in one sentence why not.
const SAME = {
  number: () => [], points: (c) => c.point, normals: (c) => c.normal,
  friction: (c) => [c.friction], stiffness: (c) => [c.stiffness], preload: (c) => [c.preload],
};
SAME.contacts = (c) => [...c.point, ...c.normal, c.friction, c.stiffness, c.preload];
const ONES = { points: "place", normals: "normal", contacts: "place, normal, friction, stiffness and preload" };

// What was changed though it has to stay; empty if nothing.
function movedFrom(start, fixed) {
  for (const name of fixed) {
    if (name === "wrench" && !state.wrench.every((x, k) => same(x, start.wrench[k]))) return "The load has to stay as it was.";
    if (name === "direction") {
      const [a, b] = [start.wrench, state.wrench];
      const parallel = [[0, 1], [1, 2], [0, 2]].every(([i, j]) => same(times(a[i], b[j]), times(a[j], b[i])));
      if (!parallel || dotted(a, b).n <= 0n) return "The load has to keep its direction.";
    }
    if (!(name in SAME)) continue;
    if (state.grasp.length !== start.grasp.length) return `There have to be ${start.grasp.length} contacts.`;
    const i = state.grasp.findIndex((c, k) => !SAME[name](c).every((x, j) => same(x, SAME[name](start.grasp[k])[j])));
    if (i >= 0) return `Contact ${i + 1} has to keep its ${ONES[name] ?? name}.`;
  }
  return "";
}

const GOALS = {
  resisted(wanted) {
    const { stable } = firstOf(state.grasp, state.wrench);
    return { solved: stable === wanted, words: stable ? "The grasp resists this load." : "The grasp does not resist this load." };
  },
  equilibria(least) {
    const { length } = allOf(state.grasp, state.wrench);
    return { solved: length >= least, words: `This load has ${count(length, "equilibrium", "equilibria")}.` };
  },
  states(wanted) {
    const found = allOf(state.grasp, state.wrench).map(({ states }) => states);
    const solved = found.some((states) => states.length === wanted.length && states.every((s, i) => [s, "any"].includes(wanted[i])));
    return { solved, words: found.length ? `The states are ${found.map((states) => states.join(", ")).join("; or ")}.` : "The grasp does not resist this load." };
  },
  gap() {
    if (!state.wrench.some((x) => x.n)) return { solved: false, words: "The load is 0, so there is no ray." };
    const found = intervalsOf(state.grasp, state.wrench);
    if (found.some(([low, high]) => (!low || order(low, ONE) <= 0) && (!high || order(high, ONE) >= 0))) return { solved: false, words: "The grasp resists this load." };
    const weaker = found.some(([, high]) => high && order(high, ONE) < 0 && order(high, ZERO) >= 0);
    const stronger = found.some(([low]) => low && order(low, ONE) > 0);
    return { solved: weaker && stronger, words: !stronger ? "No stronger push along the ray is resisted." : !weaker ? "No weaker push along the ray is resisted."
      : `Of this load the multiples that are resisted are ${found.map(rangeText).join(" and ")}.` };
  },
  border() {
    if (!state.wrench.some((x) => x.n)) return { solved: false, words: "The load is 0." };
    const found = intervalsOf(state.grasp, state.wrench);
    const solved = Boolean(found.at(-1)?.[1] && same(found.at(-1)[1], ONE));
    const { stable } = firstOf(state.grasp, state.wrench);
    return { solved, words: solved ? "A hair more is refused." : stable ? "More is resisted, too." : "The grasp does not resist this load." };
  },
  method({ name, says }) {
    const [right, other] = [firstOf(state.grasp, state.wrench).stable, saidBy(name, state.grasp, state.wrench)];
    const words = `The complete model ${right ? "accepts" : "refuses"} this load, ${METHODS[name].name.split(":")[0]} ${other ? "accepts" : "refuses"} it.`;
    return { solved: right !== other && other === says, words };
  },
  refutes() {
    if (!state.motion) return { solved: false, words: "Choose a motion." };
    const words = refutationBy(state.motion);
    return { solved: !words, words: words || "On this motion the load works more than all contacts can take away." };
  },
  regions(number) {
    const { regions } = countsOf(slipPlanes(state.grasp));
    return { solved: regions === number, words: `There are ${count(regions, "region", "regions")}.` };
  },
};

// Why a motion alone does not refute the load, whatever the contacts do; empty if it does. With spring
// forces e = q - k N.d, shares alpha e of them have to sum to a number, and no contact works less.
function refutationBy(motion) {
  const m = state.grasp.length;
  const unit = (i, value, constant) => [...Array.from({ length: m }, (_, k) => (k === i ? value : ZERO)), constant];
  const contacts = state.grasp.map((contact) => ({ contact, ...wrenchesOf(contact) }));
  const kappas = contacts.map(({ contact, N, T }) => less(dotted(motion, N), times(contact.friction, size(dotted(motion, T)))));
  const bad = kappas.findIndex((kappa) => kappa.n < 0n);
  if (bad >= 0) return `Contact ${bad + 1} can push so that it takes work away from this motion.`;
  const cancel = [0, 1, 2].map((j) => [...contacts.map(({ contact, N }) => times(contact.stiffness, N[j])), ZERO]);
  const bounds = kappas.flatMap((kappa, i) => [unit(i, ONE, ZERO), unit(i, minus(ONE), kappa)]);
  const room = [...contacts.map(({ contact }) => contact.preload), dotted(motion, state.wrench)];
  const found = new Dictionary(m, cancel, bounds, [room]);
  found.feasible();
  const most = found.extreme(0, 1n);
  return most && most.n <= 0n ? `Load and contacts together work at least ${shortText(most)} on this motion, which is not above 0.` : "";
}

function judge({ start, fixed, goal }) {
  const moved = movedFrom(readState(start, data.most), fixed);
  if (moved) return { solved: false, words: moved };
  const [[kind, value]] = Object.entries(goal);
  return GOALS[kind](value);
}

function beginExercise({ start }) {
  state.motion = null;
  load(readState(start, data.most));
}

// While a refutation is looked for, the page does not show its own.
const proofHidden = () => {
  const exercise = data.exercises[exercises.at];
  return Boolean(exercise && "refutes" in exercise.goal && !exercises.solved.has(exercises.at));
};
