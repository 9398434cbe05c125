// Exercises: whether the present state reaches a goal, and in one sentence why not.
const SAME = {
  number: () => [], points: (c) => c.point, normals: (c) => c.normal,
  friction: (c) => [c.friction], stiffness: (c) => [c.stiffness], preload: (c) => [c.preload],
};
SAME.contacts = (c) => [...c.point, ...c.normal, c.friction, c.stiffness, c.preload];
const ONES = { points: "place", normals: "normal", contacts: "place, normal, friction, stiffness and preload" };

// What an editor of exercises may ask for.
const ASKED = [
  ["whether the load is resisted", { resisted: undefined }], ["how many equilibria there are, or more", { equilibria: undefined }],
  ["these states of all contacts", { states: undefined }], ["the largest resisted load of its ray", { border: undefined }],
  ["a load in a gap of its ray", { gap: undefined }], ["the regions of the tangential planes", { regions: undefined }],
  ["the chosen motion refutes the load", { refutes: undefined }],
  ...Object.keys(METHODS).filter((name) => name !== "complete")
    .map((name) => [`the opposite is predicted by ${METHODS[name].name.split(":")[0]}`, { method: { name } }]),
];
const ASKED_TOGETHER = false;
const fixable = () => [...Object.keys(SAME), "wrench", "direction"].map((name) => [name, FIXED_WORDS[name] ?? name]);
const FIXED_WORDS = { number: "number of contacts", points: "places", contacts: "all of the contacts", wrench: "load", direction: "direction of the load" };
const startOf = (text) => readState(text, data.most);

// What was changed though it has to stay; empty if nothing.
function movedFrom(start, fixed, { grasp, wrench }) {
  for (const name of fixed) {
    if (name === "wrench" && !wrench.every((x, k) => same(x, start.wrench[k]))) return "The load must not change.";
    if (name === "direction") {
      const [a, b] = [start.wrench, wrench];
      const parallel = [[0, 1], [1, 2], [0, 2]].every(([i, j]) => same(times(a[i], b[j]), times(a[j], b[i])));
      if (!parallel || dotted(a, b).n <= 0n) return "The load must keep its direction.";
    }
    if (!(name in SAME)) continue;
    if (grasp.length !== start.grasp.length) return `There must be ${start.grasp.length} contacts.`;
    const i = grasp.findIndex((c, k) => !SAME[name](c).every((x, j) => same(x, SAME[name](start.grasp[k])[j])));
    if (i >= 0) return `Contact ${i + 1} must keep its ${ONES[name] ?? name}.`;
  }
  return "";
}

// By the kind of goal; a goal without a value has that of the state. What takes long is asked of a worker.
const work = inBackground(doing);
const REFUSED = "The grasp does not resist this load.";
const GOALS = {
  async resisted(wanted, { grasp, wrench }) {
    const stable = await work.ask({ task: "resists", grasp, wrench });
    return { value: stable, solved: stable === (wanted ?? stable), words: stable ? "The grasp resists this load." : REFUSED };
  },
  async equilibria(least, { grasp, wrench }) {
    const found = await work.ask({ task: "all", grasp, wrench });
    return { value: found.length, solved: found.length >= (least ?? 1), words: `This load has ${equilibriaWords(found)}.` };
  },
  async states(wanted, { grasp, wrench }) {
    const found = (await work.ask({ task: "all", grasp, wrench })).map(({ states }) => states);
    const shown = String(state.shownPiece()?.states);
    const value = wanted ?? found.find((states) => String(states) === shown) ?? found[0];
    const solved = found.some((states) => states.length === value.length && states.every((s, i) => [s, "any"].includes(value[i])));
    return { value, solved, words: found.length ? `The states are ${found.map((states) => states.join(", ")).join("; or ")}.` : REFUSED };
  },
  async gap(_, { grasp, wrench }) {
    if (!wrench.some((x) => x.n)) return { solved: false, words: "The load is 0, so there is no ray." };
    const found = await work.ask({ task: "multiples", grasp, wrench });
    if (found.some(([low, high]) => (!low || order(low, ONE) <= 0) && (!high || order(high, ONE) >= 0))) return { solved: false, words: "The grasp resists this load." };
    const weaker = found.some(([, high]) => high && order(high, ONE) < 0 && order(high, ZERO) >= 0);
    const stronger = found.some(([low]) => low && order(low, ONE) > 0);
    return { value: true, solved: weaker && stronger, words: !stronger ? "No stronger push along the ray is resisted." : !weaker ? "No weaker push along the ray is resisted."
      : `The resisted multiples of this load are ${found.map(rangeText).join(" and ")}.` };
  },
  async border(_, { grasp, wrench }) {
    if (!wrench.some((x) => x.n)) return { solved: false, words: "The load is 0." };
    const found = await work.ask({ task: "multiples", grasp, wrench });
    const solved = Boolean(found.at(-1)?.[1] && same(found.at(-1)[1], ONE));
    const stable = await work.ask({ task: "resists", grasp, wrench });
    return { value: true, solved, words: solved ? "No larger multiple of the load is resisted." : stable ? "A larger multiple of the load is resisted." : REFUSED };
  },
  async method({ name, says }, { grasp, wrench }) {
    const right = await work.ask({ task: "resists", grasp, wrench });
    const other = await work.ask({ task: "said", grasp, wrench, method: name });
    const words = `In the full model this load is ${right ? "" : "not "}resisted; ${METHODS[name].name.split(":")[0]} predicts ${other ? "" : "not "}resisted.`;
    return { value: { name, says: other }, solved: right !== other && other === (says ?? other), words };
  },
  async refutes(_, { grasp, wrench, motion }) {
    if (!motion) return { solved: false, words: "Choose a motion." };
    const words = refutationBy(motion, grasp, wrench);
    return { value: true, solved: !words, words: words || "On this motion the load does more work than the contacts can absorb." };
  },
  async regions(wanted, { grasp }) {
    const { regions } = countsOf(slipPlanes(grasp));
    return { value: regions, solved: regions === (wanted ?? regions), words: `There are ${count(regions, "region", "regions")}.` };
  },
};

// Why a motion alone does not refute the load, whatever the contacts do; empty if it does. With spring
// forces e = q - k N.d, shares alpha e of them have to sum to a number, and no contact works less.
function refutationBy(motion, grasp, wrench) {
  const m = grasp.length;
  const unit = (i, value, constant) => [...Array.from({ length: m }, (_, k) => (k === i ? value : ZERO)), constant];
  const contacts = grasp.map((contact) => ({ contact, ...wrenchesOf(contact) }));
  const kappas = contacts.map(({ contact, N, T }) => less(dotted(motion, N), times(contact.friction, size(dotted(motion, T)))));
  const bad = kappas.findIndex((kappa) => kappa.n < 0n);
  if (bad >= 0) return `Contact ${bad + 1} can push so that it takes work away from this motion.`;
  const cancel = [0, 1, 2].map((j) => [...contacts.map(({ contact, N }) => times(contact.stiffness, N[j])), ZERO]);
  const bounds = kappas.flatMap((kappa, i) => [unit(i, ONE, ZERO), unit(i, minus(ONE), kappa)]);
  const room = [...contacts.map(({ contact }) => contact.preload), dotted(motion, wrench)];
  const found = new Dictionary(m, cancel, bounds, [room]);
  found.feasible();
  const most = found.extreme(0, 1n);
  return most && most.n <= 0n ? `Load and contacts together work at least ${shortText(most)} on this motion, which is not above 0.` : "";
}

async function judge({ start, fixed, goal }, /** @type {any} */ given = state) {
  const moved = movedFrom(startOf(start), fixed, given);
  if (moved) return { solved: false, words: moved };
  const [[kind, value]] = Object.entries(goal);
  return GOALS[kind](value, given);
}

function beginExercise({ start }) {
  state.motion = null;
  load(startOf(start));
}

// While a refutation is looked for, the page does not show its own.
const proofHidden = () => {
  const exercise = data.exercises[exercises.at];
  return Boolean(exercise && "refutes" in exercise.goal && !exercises.solved.has(exercises.at));
};
